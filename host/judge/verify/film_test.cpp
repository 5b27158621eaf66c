// Estimates the errors of regions from the variances of pixels, and tests them.
#include "host/judge/verify/film_test.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "host/base/setting_words.h"
#include "host/base/statistics/error_rates.h"
#include "host/judge/verify/agreement.h"

namespace candela::verify {
namespace {

using Variances = std::vector<float>;

const SideNames kFilmNames{"A", "B"};

Variances largerOf(const Variances& a, const Variances& b) {
  Variances larger(a.size());
  std::transform(a.begin(), a.end(), b.begin(), larger.begin(), [](float x, float y) { return std::max(x, y); });
  return larger;
}

bool isUsable(const image::Image& image, std::size_t pixel) {
  const glm::vec3& rgb = image.rgb[pixel];
  const float variance = image.luminanceVariance[pixel];
  return std::isfinite(rgb.r) && std::isfinite(rgb.g) && std::isfinite(rgb.b) && std::isfinite(variance) &&
         variance >= 0;
}

std::optional<std::string> whyNotTestable(const std::string& name, const image::Image& image) {
  if (const auto reason = whyNotMeasured(name, image)) return reason;
  if (image.metadata.contains(kSeedMetadata)) return std::nullopt;
  return fmt::format("{} does not state its seed ({}), and the test requires images of different seeds", name,
                     kSeedMetadata);
}

}  // namespace

std::optional<std::string> whyNotMeasured(const std::string& name, const image::Image& image) {
  if (const auto bias = image.metadata.find(kBiasMetadata); bias != image.metadata.end()) {
    return fmt::format("{} is biased on purpose ({}: {})", name, kBiasMetadata, bias->second);
  }
  if (!carriesVariance(image))
    return name + " has no variances and sample counts; EXR files of candela render have them";
  for (std::size_t pixel = 0; pixel < image.rgb.size(); ++pixel) {
    if (image.sampleCounts[pixel] < 2)
      return fmt::format("{} has pixels with fewer than two samples: render it with a larger {}", name,
                         settingWords("spp"));
    if (!isUsable(image, pixel)) return name + " has values that are not finite, or a negative variance";
  }
  return std::nullopt;
}

statistics::Estimate estimateRegion(const image::Image& image, const std::vector<float>& variances,
                                    const Region& region) {
  double sum = 0;
  double squaredError = 0;
  double uncertainty = 0;  // half the variance of the squared error
  for (std::uint32_t y = region.y; y < region.y + region.height; ++y) {
    for (std::uint32_t x = region.x; x < region.x + region.width; ++x) {
      const std::size_t pixel = std::size_t{y} * image.width + x;
      const double count = image.sampleCounts[pixel];
      const double pixelError = variances[pixel] / count;
      sum += image::luminance(glm::dvec3(image.rgb[pixel]));
      squaredError += pixelError;
      uncertainty += pixelError * pixelError / (count - 1);
    }
  }
  const double pixels = double{1} * region.width * region.height;
  const double freedom = uncertainty > 0 ? squaredError * squaredError / uncertainty : 1;
  return {sum / pixels, squaredError / (pixels * pixels), freedom};
}

bool carriesVariance(const image::Image& image) {
  return !image.luminanceVariance.empty() && !image.sampleCounts.empty();
}

std::optional<std::string> whyNotTestable(const image::Image& a, const image::Image& reference) {
  if (const auto reason = whyNotTestable("A", a)) return reason;
  if (const auto reason = whyNotTestable("B", reference)) return reason;
  if (a.metadata.at(kSeedMetadata) != reference.metadata.at(kSeedMetadata)) return std::nullopt;
  return fmt::format(
      "A and B have the same seed, but the test requires independent random numbers: render one of them with another "
      "{}",
      settingWords("seed"));
}

FilmTestResult testFilms(const image::Image& a, const image::Image& reference, const LightTestOptions& options) {
  std::vector<Region> regions = regionsOf({a.width, a.height});
  std::erase_if(regions, [](const Region& region) { return region.quantity != Region::Quantity::luminance; });
  const bool equalCounts = a.sampleCounts == reference.sampleCounts;
  const Variances larger = equalCounts ? Variances{} : largerOf(a.luminanceVariance, reference.luminanceVariance);

  FilmTestResult result{
      {statistics::sidakLevel(options.alpha, regions.size()), {}}, options.alpha, options.maxOverlooked()};
  for (const Region& region : regions) {
    result.regions.push_back(compareRegion(
        region, estimateRegion(a, equalCounts ? a.luminanceVariance : larger, region),
        estimateRegion(reference, equalCounts ? reference.luminanceVariance : larger, region), result.level));
  }
  return result;
}

Conclusion FilmTestResult::conclusion() const {
  if (differs()) return Conclusion::different;
  return doubt() == Doubt::none ? Conclusion::same : Conclusion::undecided;
}

std::string FilmTestResult::verdict() const {
  if (differs()) {
    const RegionResult& most = mostSignificant();
    return fmt::format("A and B do NOT show the same light: the {} is {:.3f} % {} in A ({} over all tests).",
                       regionText(most.region), 100 * std::abs(most.relativeDifference()),
                       most.test.difference > 0 ? "brighter" : "darker",
                       pValueText(statistics::sidakPValue(most.test.pValue, regions.size())));
  }
  if (conclusion() == Conclusion::undecided) {
    return doubtText(doubt(), image(), maxOverlooked, kFilmNames) + remedyText(doubt(), image(), "More samples");
  }
  return fmt::format(
      "A and B show the same light within their noise: a difference of {:.2g} % of the image mean would have been "
      "detected with {:.0f} % probability.",
      100 * image().detectableBias, 100 * kPower);
}

std::string toText(const FilmTestResult& result) {
  std::string text = fmt::format("same light?           {}: {} tests at p < {:.1e}\n",
                                 result.differs()                ? "NO"
                                 : result.doubt() == Doubt::none ? "yes"
                                                                 : "not decided",
                                 result.regions.size(), result.level);
  text += fmt::format("                      {}\n", differenceText(result.image()));
  const RegionResult& most = result.mostSignificant();
  if (&most != &result.image()) text += fmt::format("                      {}\n", differenceText(most));
  return text + result.verdict() + "\n";
}

nlohmann::ordered_json toJson(const FilmTestResult& result) {
  nlohmann::ordered_json json{{"agrees", agreesJson(result.conclusion())},
                              {"verdict", result.verdict()},
                              {"undecided", doubtJson(result.doubt(), result.image(), result.maxOverlooked)},
                              {"alpha", result.alpha},
                              {"level", result.level}};
  for (const RegionResult& region : result.regions) json["regions"].push_back(regionJson(region, "mean"));
  return json;
}

}  // namespace candela::verify

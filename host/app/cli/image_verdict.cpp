// Combines the tolerance and the statistical test.
#include "host/app/cli/image_verdict.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "host/base/errors.h"

namespace candela::cli {
namespace {

std::string toleranceText(const ImageVerdict& verdict) {
  std::string text = fmt::format("{}: the tolerance of relMSE is {:g}", verdict.withinTolerance ? "PASS" : "FAIL",
                                 *verdict.tolerance);
  if (!verdict.exceeding.empty()) text += fmt::format(", beyond which are: {}", fmt::join(verdict.exceeding, ", "));
  return text;
}

// Returns whether the image has the statistics that the test needs, or lost them because its light was changed on
// purpose.
bool isMeasurement(const image::Image& image) {
  return verify::carriesVariance(image) || image.metadata.contains(verify::kBiasMetadata);
}

// Adds the result of the test, or the reason why there is none.
void test(ImageVerdict& verdict, const CompareArguments& arguments, const image::Image& a,
          const image::Image& reference) {
  const bool asked = arguments.given.contains("--alpha");
  if (!asked && (verdict.tolerance || !isMeasurement(a) || !isMeasurement(reference))) return;
  const std::optional<std::string> obstacle = verify::whyNotTestable(a, reference);
  if (asked && obstacle) throw UsageError("--alpha: " + *obstacle);
  if (obstacle) {
    verdict.whyNoTest = *obstacle;
  } else {
    verdict.films = verify::testFilms(a, reference, arguments.verification);
  }
}

}  // namespace

ImageVerdict judgeImages(const CompareArguments& arguments, const image::Image& a, const image::Image& reference,
                         const image::ImageComparison& comparison, const image::ChannelComparison& channels) {
  ImageVerdict verdict;
  verdict.tolerance = arguments.tolerance;
  if (verdict.tolerance) {
    // If a value is not finite, its error is undefined, and the tolerance is exceeded.
    const bool coloursAgree = comparison.notFiniteCount == 0 &&
                              comparison.relativeMeanSquaredError <= *verdict.tolerance;
    if (channels.comparesColours && !coloursAgree) verdict.exceeding.emplace_back("colours");
    for (const image::ChannelDifference& channel : channels.channels) {
      if (!channel.isWithin(*verdict.tolerance)) verdict.exceeding.push_back(channel.name);
    }
    verdict.withinTolerance = verdict.exceeding.empty();
  }
  test(verdict, arguments, a, reference);
  return verdict;
}

verify::Conclusion ImageVerdict::conclusion() const {
  if (!whyApart.empty() || !withinTolerance) return verify::Conclusion::different;
  return films ? films->conclusion() : verify::Conclusion::same;
}

std::string ImageVerdict::sentence() const {
  if (!whyApart.empty()) return "The pictures cannot be compared pixel by pixel: " + whyApart + ".";
  std::string text;
  if (tolerance) {
    text = fmt::format("relMSE is {} the tolerance of {:g}", withinTolerance ? "within" : "NOT within", *tolerance);
    text += exceeding.empty() ? "." : fmt::format(" ({}).", fmt::join(exceeding, ", "));
  }
  if (films) text += (text.empty() ? "" : " ") + films->verdict();
  if (!whyNoTest.empty()) text += fmt::format("There is no verdict on the light: {}.", whyNoTest);
  return text.empty() ? "No verdict was requested; --tolerance requests one." : text;
}

std::string toText(const ImageVerdict& verdict) {
  if (!verdict.whyApart.empty()) return verdict.sentence() + "\n";
  std::string text;
  if (verdict.tolerance) text += toleranceText(verdict) + "\n";
  if (verdict.films) text += toText(*verdict.films);
  if (!verdict.whyNoTest.empty()) text += verdict.sentence() + "\n";
  return text;
}

void addToJson(const ImageVerdict& verdict, nlohmann::ordered_json& json) {
  json["agrees"] = verdict.isGiven() ? verify::agreesJson(verdict.conclusion()) : nlohmann::ordered_json();
  if (!verdict.whyApart.empty()) json["apart"] = verdict.whyApart;
  if (verdict.tolerance) json["exceeding"] = verdict.exceeding;
  if (verdict.films) json["sameLight"] = toJson(*verdict.films);
  if (!verdict.whyNoTest.empty()) json["noVerdict"] = verdict.whyNoTest;
}

}  // namespace candela::cli

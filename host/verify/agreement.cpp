// Compares images pixel by pixel, with path records.
#include "host/verify/agreement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace candela::verify {
namespace {

bool equalChannels(const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 tolerance = glm::max(kRelativeTolerance * glm::max(glm::abs(a), glm::abs(b)), kAbsoluteTolerance);
  return glm::all(glm::lessThanEqual(glm::abs(a - b), tolerance));
}

double meanLuminance(const image::Film& film) {
  double sum = 0;
  for (std::uint32_t y = 0; y < film.height(); ++y) {
    for (std::uint32_t x = 0; x < film.width(); ++x) sum += image::luminance(film.mean(x, y));
  }
  return sum / (static_cast<double>(film.width()) * film.height());
}

void noteDifference(PixelAgreement& result, double difference, std::uint32_t x, std::uint32_t y) {
  if (difference <= result.worst) return;
  result.worst = difference;
  result.worstX = x;
  result.worstY = y;
}

}  // namespace

double MeanAgreement::relativeDifference() const {
  if (device == reference) return 0;
  return reference > 0 ? std::abs(device - reference) / reference : 1;
}

Cause causeOf(const render::PathRecord& device, const render::PathRecord& reference) {
  const std::uint32_t count = std::max(device.vertexCount, reference.vertexCount);
  for (std::uint32_t i = 0; i < count; ++i) {
    const render::VertexRecord& a = device.vertices[i];
    const render::VertexRecord& b = reference.vertices[i];
    if (i >= device.vertexCount || i >= reference.vertexCount) return Cause::roulette;
    if (a.primitive != b.primitive) return Cause::primitive;
    if (a.shadow != b.shadow || a.visibleLights != b.visibleLights) return Cause::shadow;
    if (a.lobe != b.lobe) return Cause::lobe;
    if (a.survivedRoulette != b.survivedRoulette) return Cause::roulette;
  }
  return Cause::rounding;
}

PixelAgreement comparePixels(const render::RenderResult& device, const render::RenderResult& reference) {
  PixelAgreement result;
  for (std::uint32_t y = 0; y < device.film.height(); ++y) {
    for (std::uint32_t x = 0; x < device.film.width(); ++x) {
      const glm::dvec3 a = device.film.mean(x, y);
      const glm::dvec3 b = reference.film.mean(x, y);
      const bool lit = a != glm::dvec3(0) || b != glm::dvec3(0);
      const bool equal = equalChannels(a, b);
      result.pixels += 1;
      result.equal += equal;
      result.lit += lit;
      result.litEqual += lit && equal;
      if (equal) continue;
      const std::size_t pixel = std::size_t{y} * device.film.width() + x;
      result.causes[static_cast<std::size_t>(causeOf(device.paths[pixel], reference.paths[pixel]))] += 1;
      const glm::dvec3 difference = glm::abs(a - b);
      noteDifference(result, std::max({difference.x, difference.y, difference.z}), x, y);
    }
  }
  return result;
}

std::optional<PixelAgreement> comparePaths(const scene::Scene& scene, const render::RenderSettings& settings,
                                           render::Renderer& device, render::Renderer& reference,
                                           const render::RenderControl& control, render::BadSampleTallies& badSamples) {
  render::RenderSettings single = settings;
  single.image.sampleCount = 1;
  single.execution.recordPaths = true;
  const render::RenderResult a = device.render(scene, single, control);
  const render::RenderResult b = reference.render(scene, single, control);
  badSamples.device.add(a.film, single.image);
  badSamples.reference.add(b.film, single.image);
  return a.interrupted || b.interrupted ? std::nullopt : std::optional(comparePixels(a, b));
}

std::string PixelAgreement::causesText() const {
  std::string text;
  for (std::size_t i = 0; i < causes.size(); ++i) text += fmt::format(" {} {}", kCauseNames[i], causes[i]);
  if (worst > 0) text += fmt::format("; largest {:.6g} at {},{}", worst, worstX, worstY);
  return text;
}

nlohmann::ordered_json PixelAgreement::causesJson() const {
  nlohmann::ordered_json json;
  for (std::size_t i = 0; i < causes.size(); ++i) json[kCauseNames[i]] = causes[i];
  return json;
}

nlohmann::ordered_json PixelAgreement::worstJson() const {
  return {{"difference", worst}, {"x", worstX}, {"y", worstY}};
}

AgreementReport compareTracers(const scene::Scene& scene, const render::RenderSettings& settings,
                               render::Renderer& device, render::Renderer& reference,
                               const render::RenderControl& control) {
  AgreementReport report;
  report.scene = scene.name;
  const std::optional<PixelAgreement> pixels = comparePaths(scene, settings, device, reference, control,
                                                            report.badSamples);
  report.pixels = pixels.value_or(PixelAgreement{});
  render::RenderResult deviceMany = device.render(scene, settings, control);
  render::RenderResult referenceMany = reference.render(scene, settings, control);
  report.badSamples.device.add(deviceMany.film, settings.image);
  report.badSamples.reference.add(referenceMany.film, settings.image);
  report.mean = {settings.image.sampleCount, meanLuminance(deviceMany.film), meanLuminance(referenceMany.film)};
  report.deviceStatistics = deviceMany.statistics;
  report.deviceFilm = std::move(deviceMany.film);
  report.referenceFilm = std::move(referenceMany.film);
  report.interrupted = !pixels || deviceMany.interrupted || referenceMany.interrupted;
  return report;
}

std::string AgreementReport::toText() const {
  std::string text = fmt::format("{}: {} compared with the reference\n", scene, deviceStatistics.device);
  text += fmt::format(
      "  1 sample: {:.3f} % of {} pixels equal (at least {} %), {:.3f} % of {} lit pixels (at least {} %)\n",
      100 * pixels.share(), pixels.pixels, 100 * kRequiredShare, 100 * pixels.litShare(), pixels.lit,
      100 * kRequiredLitShare);
  text += "  first differences of the other pixels:" + pixels.causesText();
  text += fmt::format("\n  {} samples: mean {:.8g}, reference {:.8g}, relative difference {:.2e} (at most {:.0e})\n",
                      mean.samples, mean.device, mean.reference, mean.relativeDifference(), kMeanTolerance);
  text += interrupted ? "  interrupted: no verdict\n" : agree() ? "  they agree\n" : "  they DIFFER\n";
  return text;
}

nlohmann::json AgreementReport::toJson() const {
  return {{"scene", scene},
          {"device", deviceStatistics.device},
          {"driver", deviceStatistics.driver},
          {"agree", agree()},
          {"interrupted", interrupted},
          {"pixels",
           {{"count", pixels.pixels},
            {"equal", pixels.equal},
            {"share", pixels.share()},
            {"lit", pixels.lit},
            {"litEqual", pixels.litEqual},
            {"litShare", pixels.litShare()},
            {"causes", pixels.causesJson()},
            {"worst", pixels.worstJson()}}},
          {"mean",
           {{"samples", mean.samples},
            {"device", mean.device},
            {"reference", mean.reference},
            {"relativeDifference", mean.relativeDifference()}}}};
}

}  // namespace candela::verify

// Answers the three questions of `candela verify`.
#include "host/verify/verify.h"

#include <algorithm>
#include <cmath>

#include "host/core/stopwatch.h"
#include "host/statistics/error_rates.h"
#include "host/verify/paired_test.h"

namespace candela::verify {
namespace {

using statistics::Summary;

// Returns the pixels of the area, at least the one in its middle.
Region regionOf(const scene::ExactMean& exact, const render::Extent& image) {
  const auto first = [](float share, std::uint32_t size) {
    return std::min(static_cast<std::uint32_t>(std::floor(share * static_cast<float>(size))), size - 1);
  };
  const auto count = [](float share, std::uint32_t size) {
    return std::max(1u, static_cast<std::uint32_t>(std::lround(share * static_cast<float>(size))));
  };
  Region region{first(exact.area.x, image.width), first(exact.area.y, image.height), 0, 0, 0,
                Region::Quantity::luminance};
  region.width = std::min(count(exact.area.z, image.width), image.width - region.x);
  region.height = std::min(count(exact.area.w, image.height), image.height - region.y);
  return region;
}

double pValueAgainst(const Summary& measured, double expected) {
  const Summary exact{kBatchCount, expected, 0};
  return statistics::welch(measured, exact, kRelativeTolerance * expected + kAbsoluteTolerance).pValue;
}

// Both sides render with seeds of their own: the exact result knows nothing of the noise that they share.
void testExact(const scene::Scene& scene, const render::RenderSettings& settings, render::Renderer& device,
               render::Renderer& reference, const LightTestOptions& options, const render::RenderControl& control,
               VerifyReport& report) {
  LightTestOptions own = options;
  own.bias = std::max(options.bias.value_or(0), kIndependentBias);
  own.keepFilms = false;
  own.watched = regionOf(*scene.exactMean, settings.image.size);
  const LightTestResult light = testLight(scene, settings, device, reference, own, control);
  report.tallies.add(light.tallies);
  report.interrupted = light.interrupted;
  if (report.interrupted) return;
  ExactTest test;
  test.expected = image::luminance(glm::dvec3(scene.exactMean->rgb));
  test.device = light.watchedDevice.mean;
  test.reference = light.watchedReference.mean;
  test.devicePValue = pValueAgainst(light.watchedDevice, test.expected);
  test.referencePValue = pValueAgainst(light.watchedReference, test.expected);
  test.level = statistics::sidakLevel(own.alpha, 2);
  report.exact = test;
}

}  // namespace

VerifyReport verifyScene(const scene::Scene& scene, const render::RenderSettings& settings, render::Renderer& device,
                         render::Renderer& reference, const LightTestOptions& options,
                         const render::RenderControl& control) {
  Stopwatch watch;
  VerifyReport report;
  report.scene = scene.name;
  report.options = options;
  // Each question is a separate test, so that alpha is divided evenly.
  LightTestOptions own = options;
  own.alpha = options.alpha / (scene.exactMean ? 3 : 2);
  const std::optional<PixelAgreement> paths = comparePaths(scene, settings, device, reference, own.alpha, control,
                                                           report.tallies);
  report.interrupted = !paths;
  if (report.interrupted) return report;
  report.paths = *paths;

  report.light = options.method == LightTestMethod::paired
                     ? testLightPaired(scene, settings, device, reference, own, paths->referenceMean, control)
                     : testLight(scene, settings, device, reference, own, control);
  report.tallies.add(report.light.tallies);
  report.interrupted = report.light.interrupted;
  if (scene.exactMean && !report.interrupted) testExact(scene, settings, device, reference, own, control, report);
  report.seconds = watch.lap();
  return report;
}

}  // namespace candela::verify

// Answers the three questions of `candela verify`.
#include "host/verify/verify.h"

#include "host/core/stopwatch.h"
#include "host/verify/paired_test.h"

namespace candela::verify {
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
  if (scene.exactMean) own.watched = regionOf(*scene.exactMean, settings.image.size);
  const std::optional<PixelAgreement> paths = comparePaths(scene, settings, device, reference, own.alpha, control,
                                                           report.tallies);
  report.interrupted = !paths;
  if (report.interrupted) return report;
  render::requireComplete(paths->deviceStatistics);
  report.paths = *paths;

  report.light = options.method == LightTestMethod::paired
                     ? testLightPaired(scene, settings, device, reference, own, paths->referenceMean, control)
                     : testLight(scene, settings, device, reference, own, control);
  report.tallies.add(report.light.tallies);
  report.interrupted = report.light.interrupted;
  if (scene.exactMean && !report.interrupted) {
    report.exact = testExactMean(scene, settings, device, own, report.light, control, report.tallies.device);
    report.interrupted = !report.exact;
  }
  report.seconds = watch.lap();
  return report;
}

}  // namespace candela::verify

// Answers the three questions of `candela verify`.
#include "host/judge/verify/verify.h"

#include "host/base/stopwatch.h"
#include "host/judge/verify/paired_test.h"

namespace candela::verify {
namespace {

/// One run of `verifyScene`, with its arguments.
struct Questions {
  const scene::Scene& scene;
  const render::RenderSettings& settings;
  render::Renderer& device;
  render::Renderer& reference;
  const render::RenderControl& control;
  LightTestOptions options;  ///< each question is a separate test with this alpha

  // Answers the questions until an interruption.
  void answer(VerifyReport& report) {
    PathRenders renders;
    const std::optional<PixelAgreement> paths = comparePaths(scene, settings, device, reference, options.alpha, control,
                                                             renders);
    report.deviceStatistics = renders.deviceStatistics;
    report.badSamples.add(renders.badSamples);
    report.interrupted = !paths;
    if (report.interrupted) return;
    render::requireComplete(report.deviceStatistics);
    report.paths = *paths;
    report.light = light(paths->referenceMean);
    report.badSamples.add(report.light.badSamples);
    report.interrupted = report.light.interrupted;
    if (!scene.exactMean || report.interrupted) return;
    report.exact = testExactMean(scene, settings, device, reference, options, report.light, control, report.badSamples);
    report.interrupted = !report.exact;
  }

 private:
  LightTestResult light(double referenceMean) {
    return options.method == LightTestMethod::paired
               ? testLightPaired(scene, settings, device, reference, options, referenceMean, control)
               : testLight(scene, settings, device, reference, options, control);
  }
};

}  // namespace

VerifyReport verifyScene(const scene::Scene& scene, const render::RenderSettings& settings, render::Renderer& device,
                         render::Renderer& reference, const LightTestOptions& options,
                         const render::RenderControl& control) {
  Stopwatch watch;
  VerifyReport report;
  report.scene = scene.name;
  report.options = options;
  Questions questions{scene, settings, device, reference, control, options};
  questions.options.alpha = options.alpha / (scene.exactMean ? 3 : 2);
  if (scene.exactMean) questions.options.watched = regionOf(*scene.exactMean, settings.image.size);
  questions.answer(report);
  report.seconds = watch.lap();
  return report;
}

}  // namespace candela::verify

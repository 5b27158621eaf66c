// Renders, compares and explains.
#include "host/conformance/picture_run.h"

#include <fmt/format.h>

#include "host/conformance/scenes.h"
#include "host/conformance/workbench.h"
#include "host/explain/explanation.h"
#include "host/verify/agreement.h"

namespace candela::conformance {
namespace {

// The first line of an explanation names the sample; its verdict says where the paths separate.
std::string explanationOf(const scene::Scene& scene, const render::RenderSettings& settings,
                          const verify::PixelAgreement& pixels, Workbench& workbench) {
  if (settings.image.integrator != render::Integrator::path) return pixels.causesText();
  const auto worst = explain::explainWorst(scene, settings, pixels, workbench.renderer(), workbench.reference());
  if (!worst) return "the pixels of one sample are equal";
  return fmt::format("pixel {},{}: {}", worst->sample.x, worst->sample.y, worst->verdict());
}

std::string differenceOf(const verify::AgreementReport& report) {
  if (!report.pixels.agree()) return report.pixels.decisions.text();
  return verify::differenceText(report.mostSignificant());
}

}  // namespace

Finding comparePicture(const std::string& sceneName, const render::RenderSettings& settings, Workbench& workbench) {
  const scene::Scene& scene = sceneNamed(sceneName);
  const verify::AgreementReport report = verify::compareTracers(scene, settings, workbench.renderer(),
                                                                workbench.reference(), kPictureAlpha, {});
  if (report.deviceStatistics.truncated > 0) {
    return failed(fmt::format("{} loops of the kernel were stopped by the device", report.deviceStatistics.truncated));
  }
  if (report.agree()) return passed();
  return failed(differenceOf(report) + "\n" + explanationOf(scene, settings, report.pixels, workbench));
}

}  // namespace candela::conformance

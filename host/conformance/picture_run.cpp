// Renders, compares and explains.
#include "host/conformance/picture_run.h"

#include <fmt/format.h>

#include "host/capture/scene_capture.h"
#include "host/conformance/identity_run.h"
#include "host/conformance/scenes.h"
#include "host/conformance/workbench.h"
#include "host/device/gpu_renderer.h"
#include "host/device/workgroup.h"
#include "host/explain/explanation.h"
#include "host/verify/agreement.h"

namespace candela::conformance {
namespace {

std::string explanationOf(const scene::Scene& scene, const render::RenderSettings& settings,
                          const verify::PixelAgreement& pixels, render::Renderer& device, render::Renderer& reference) {
  if (settings.image.integrator != render::Integrator::path) return "first differences:" + pixels.causesText();
  const auto worst = explain::explainWorst(scene, settings, pixels, device, reference);
  if (!worst) return "the pixels of one sample are equal";
  return fmt::format("pixel {},{}: {}", worst->sample.x, worst->sample.y, worst->verdict());
}

std::string differenceOf(const verify::AgreementReport& report) {
  if (!report.pixels.agree()) return report.pixels.decisions.text();
  return verify::differenceText(report.mostSignificant());
}

Finding compareOn(render::Renderer& device, const Picture& picture, render::Renderer& reference) {
  const scene::Scene& scene = sceneNamed(picture.scene);
  const verify::AgreementReport report = verify::compareTracers(scene, picture.settings, device, reference,
                                                                kPictureAlpha, {});
  if (report.deviceStatistics.truncated > 0) {
    return failed(fmt::format("the device stopped {} loops of the kernel", report.deviceStatistics.truncated));
  }
  if (report.agree()) return passed();
  return failed(differenceOf(report) + "\n" + explanationOf(scene, picture.settings, report.pixels, device, reference));
}

}  // namespace

Finding comparePicture(const Picture& picture, Workbench& workbench) {
  const vulkan::DeviceInfo& info = workbench.info();
  const render::Extent workgroup = picture.settings.execution.workgroupInUse();
  if (!device::hasWorkgroup(info, workgroup)) return skipped(missingShape(info));
  if (picture.subgroupSize == 0) return compareOn(workbench.renderer(), picture, workbench.reference());
  if (!hasSubgroupSize(info, picture.subgroupSize)) return skipped(missingSubgroupSize(info));
  vulkan::Device device = workbench.open({.subgroupSize = picture.subgroupSize});
  return compareOn(*device::makeGpuRenderer(device), picture, workbench.reference());
}

capture::Capture capturePicture(const Picture& picture, const vulkan::DeviceInfo& device,
                                const vulkan::PrepareShader& prepareShader) {
  Workbench workbench(device, {}, prepareShader);
  const scene::Scene& scene = sceneNamed(picture.scene);
  verify::PathRenders ignored;
  const auto pixels = verify::comparePaths(scene, picture.settings, workbench.renderer(), workbench.reference(),
                                           kPictureAlpha, {}, ignored);
  capture::SceneRequest request;
  request.settings = picture.settings;
  request.settings.image.sampleCount = 1;
  request.sample = {pixels->worstX, pixels->worstY, 0};
  request.device = {device, picture.subgroupSize, prepareShader};
  request.shrinkSeconds = kPictureShrinkSeconds;
  return capture::captureScene(scene, *capture::primitivesOf(scene), request);
}

}  // namespace candela::conformance

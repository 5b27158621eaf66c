// Renders, compares and explains.
#include "host/drivers/conformance/picture_run.h"

#include <fmt/format.h>

#include "host/drivers/capture/scene_capture.h"
#include "host/drivers/conformance/capture_case.h"
#include "host/drivers/conformance/case_pipeline.h"
#include "host/drivers/conformance/identity_run.h"
#include "host/drivers/conformance/scenes.h"
#include "host/drivers/conformance/workbench.h"
#include "host/judge/explain/explanation.h"
#include "host/judge/verify/agreement.h"
#include "host/trace/device/gpu_renderer.h"
#include "host/trace/device/scene_kernels.h"
#include "host/trace/device/workgroup.h"

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
  if (report.doubt() != verify::Doubt::none) return report.verdict();
  if (!report.pixels.agree()) return report.pixels.decisions.text();
  return verify::differenceText(report.mostSignificant());
}

Finding compareOn(render::Renderer& device, const Picture& picture, render::Renderer& reference) {
  const scene::Scene& scene = sceneNamed(picture.scene);
  const verify::AgreementReport report = verify::compareTracers(scene, picture.settings(), device, reference,
                                                                {.alpha = picture.alpha}, {});
  if (report.deviceStatistics.truncated > 0) {
    return failed(fmt::format("the device stopped {} loops of the kernel", report.deviceStatistics.truncated));
  }
  if (report.conclusion() == verify::Conclusion::same) return passed();
  return failed(differenceOf(report) + "\n" +
                explanationOf(scene, picture.settings(), report.pixels, device, reference));
}

// Returns the feature of the picture that the device lacks; empty: it has all.
std::string missingFor(const Picture& picture, const vulkan::DeviceInfo& device) {
  const render::Extent workgroup = picture.request.execution.workgroupInUse();
  if (!device::hasWorkgroup(device, workgroup)) return missingShape(device, {workgroup.width, workgroup.height, 1});
  if (picture.subgroupSize == 0 || hasSubgroupSize(device, picture.subgroupSize)) return "";
  return missingSubgroupSize(device, picture.subgroupSize);
}

// Returns a device whose pipelines require the subgroup size of the picture.
vulkan::Device deviceFor(const Picture& picture, Workbench& workbench) {
  return picture.subgroupSize == 0 ? workbench.device() : workbench.open({.subgroupSize = picture.subgroupSize});
}

// Returns a renderer whose pipelines require the subgroup size of the picture.
std::unique_ptr<render::Renderer> rendererFor(const Picture& picture, const Workbench& workbench) {
  return device::makeGpuRenderer(workbench.open({.subgroupSize = picture.subgroupSize}));
}

}  // namespace

render::RenderSettings Picture::settings() const { return render::resolve(request, sceneNamed(scene)); }

Finding comparePicture(const Picture& picture, Workbench& workbench) {
  if (std::string missing = missingFor(picture, workbench.info()); !missing.empty()) return skipped(std::move(missing));
  if (picture.subgroupSize == 0) return compareOn(workbench.renderer(), picture, workbench.reference());
  return compareOn(*rendererFor(picture, workbench), picture, workbench.reference());
}

Finding compilePicture(const Picture& picture, Workbench& workbench) {
  if (std::string missing = missingFor(picture, workbench.info()); !missing.empty()) return skipped(std::move(missing));
  render::RenderSettings settings = picture.settings();
  render::SceneLoads& loads = settings.execution.automatic.sceneLoads;
  if (loads == render::SceneLoads::automatic) loads = render::SceneLoads::texel;
  const device::SceneKernels kernels = device::kernelsOf(workbench.info(), sceneNamed(picture.scene), settings);
  vulkan::Device device = deviceFor(picture, workbench);
  for (const auto& spirv : kernels.kernel.spirv) create({spirv, kernels.options}, device);
  return passed();
}

capture::Capture capturePicture(const Picture& picture, const vulkan::DeviceInfo& device,
                                const vulkan::PrepareShader& prepareShader) {
  if (const std::string missing = missingFor(picture, device); !missing.empty()) refuseMissing(device, missing);
  Workbench workbench(device, {.prepareShader = prepareShader});
  const scene::Scene& scene = sceneNamed(picture.scene);
  const std::unique_ptr<render::Renderer> renderer = rendererFor(picture, workbench);
  verify::PathRenders ignored;
  const auto pixels = verify::comparePaths(scene, picture.settings(), *renderer, workbench.reference(), picture.alpha,
                                           {}, ignored);
  capture::SceneRequest request{.settings = picture.settings()};
  request.settings.image.sampleCount = 1;
  request.sample = {pixels->worstX, pixels->worstY, 0};
  request.device = {device, picture.subgroupSize, prepareShader};
  request.shrinkSeconds = kPictureShrinkSeconds;
  return capture::captureScene(scene, *capture::primitivesOf(scene), request);
}

}  // namespace candela::conformance

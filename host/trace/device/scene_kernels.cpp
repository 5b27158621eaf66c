// Chooses the kernels of a scene as a session does.
#include "host/trace/device/scene_kernels.h"

#include "host/trace/device/code_form.h"
#include "host/trace/device/device_scene.h"
#include "host/trace/device/loop_budget.h"
#include "host/trace/device/specialise.h"
#include "host/trace/device/wavefront.h"
#include "host/trace/device/workgroup.h"
#include "host/trace/render/request.h"
#include "host/trace/vulkan/loop_limit.h"
#include "spirv/empty.h"

namespace candela::device {

flatten::FlatScene flattenFor(const vulkan::DeviceInfo& info, std::uint32_t loopLimit, const scene::Scene& scene,
                              render::RenderSettings& settings, std::vector<std::string>& warnings) {
  const std::uint32_t rays = maxRaysPerSegment(scene, settings);
  preferBvh(loopLimit, info, scene, rays, settings.structure, warnings);
  return flatten::flattenScene(scene, settings, {maxGridSideFor(loopLimit, info, rays), smallSceneRule(info)});
}

SceneKernels kernelsOf(const vulkan::DeviceInfo& info, const scene::Scene& scene,
                       const render::RenderSettings& settings) {
  render::requireIntegrator(scene, settings);
  requireWorkgroup(info, settings.execution.workgroupInUse());
  render::RenderSettings used = settings;
  std::vector<std::string> warnings;
  const flatten::FlatScene flat = flattenFor(info, vulkan::kUnlimitedIterations, scene, used, warnings);
  const render::SceneLoads loads = loadsFor(info, flat, used);
  return {.kernel = kernelFor(flat, used),
          .options = kernelOptions(codeFormOf(info, vulkan::kUnlimitedIterations), flat.shape, used,
                                   loads == render::SceneLoads::texel, sizeof(gpu::DispatchConstants)),
          .structure = used.structure,
          .layout = flat.shape.layout(),
          .loads = loads,
          .workgroup = used.execution.workgroupInUse()};
}

std::string moduleName(const Kernel& kernel, std::size_t module) {
  const std::string name = nameOf(kernel.kind);
  return kernel.isWavefront() ? name + "." + kWaveStageNames.at(module) : name;
}

std::span<const std::uint32_t> emptyKernel() { return spirv::empty; }

}  // namespace candela::device

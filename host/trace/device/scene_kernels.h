// The kernels that a session compiles for a scene, without a session.
#pragma once
#include <string>
#include <vector>

#include "host/trace/device/kernel.h"
#include "host/trace/render/choices_in_use.h"
#include "host/trace/render/settings.h"
#include "host/trace/vulkan/compute_pipeline.h"
#include "host/trace/vulkan/device_info.h"

namespace candela::device {

/// Returns the scene as a session stores it on the device. `loopLimit` is the result of probeLoopLimit(). It may change
/// the structure in `settings`, and adds a sentence about that to `warnings`: see preferBvh().
flatten::FlatScene flattenFor(const vulkan::DeviceInfo& info, std::uint32_t loopLimit, const scene::Scene& scene,
                              render::RenderSettings& settings, std::vector<std::string>& warnings);

struct SceneKernels {
  Kernel kernel;
  vulkan::PipelineOptions options;  ///< of each module
  render::StructureSettings structure;
  render::LayoutInUse layout = render::LayoutInUse::none;
  render::SceneLoads loads = render::SceneLoads::texel;
  render::Extent workgroup;
};

/// Returns the kernels of a session with these settings on a device without a loop limit. Throws as
/// render::Renderer::prepare() does.
SceneKernels kernelsOf(const vulkan::DeviceInfo& info, const scene::Scene& scene,
                       const render::RenderSettings& settings);

/// Returns the name of a module of a kernel: that of the kernel, and for the wavefront that of the stage.
std::string moduleName(const Kernel& kernel, std::size_t module);

/// Returns a kernel that does nothing. It has neither bindings nor specialisation constants.
std::span<const std::uint32_t> emptyKernel();

}  // namespace candela::device

// Traces one sample again on the device, and reads back the quantities of its path.
#pragma once
#include "host/device/device_scene.h"
#include "host/device/kernel.h"
#include "host/device/loop_budget.h"
#include "host/render/renderer.h"
#include "host/vulkan/compute_pipeline.h"

namespace candela::device {

/// Returns the kernel that traces one sample of the path tracer.
Kernel replayKernel();

/// Returns the trace of one sample. Adds the loops that the device stopped to `statistics.truncated`. `pipeline` is
/// made from replayKernel() for the scene.
render::PathTrace replayOnDevice(vulkan::Device& device, const vulkan::ComputePipeline& pipeline,
                                 const DeviceScene& scene, const render::PixelSample& sample, std::uint32_t maxDepth,
                                 const LoopBudget& budget, render::RenderStatistics& statistics);

}  // namespace candela::device

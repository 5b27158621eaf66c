// Traces one sample again on the device, and reads back the quantities of its path.
#pragma once
#include "host/trace/device/device_scene.h"
#include "host/trace/device/kernel.h"
#include "host/trace/device/loop_budget.h"
#include "host/trace/render/renderer.h"
#include "host/trace/vulkan/compute_pipeline.h"

namespace candela::device {

/// Returns the kernel that traces one sample of the path tracer.
Kernel replayKernel();

/// Returns the trace of one sample. Adds the loops that the device stopped to `statistics.truncated`. `pipeline` is
/// made from replayKernel() for the scene.
render::PathTrace replayOnDevice(vulkan::Device& device, const vulkan::ComputePipeline& pipeline,
                                 const DeviceScene& scene, const render::PixelSample& sample, std::uint32_t maxDepth,
                                 const LoopBudget& budget, render::RenderStatistics& statistics);

}  // namespace candela::device

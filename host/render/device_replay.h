// Traces one sample again on the device, and reads what its path left behind.
#pragma once
#include "host/render/device_scene.h"
#include "host/render/kernel.h"
#include "host/render/loop_budget.h"
#include "host/render/replay.h"
#include "host/vulkan/compute_pipeline.h"

namespace candela {

/// The kernel that traces one sample of the path tracer.
Kernel replayKernel();

/// Adds loops that the device stopped to `statistics.truncated`. `pipeline` is made of replayKernel() for the scene.
PathTrace replayOnDevice(vulkan::Device& device, const vulkan::ComputePipeline& pipeline, const DeviceScene& scene,
                         const PixelSample& sample, const LoopBudget& budget, RenderStatistics& statistics);

}  // namespace candela

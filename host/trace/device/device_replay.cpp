// Traces one sample of one pixel again on the device.
#include "host/trace/device/device_replay.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <span>

#include "host/base/errors.h"
#include "host/trace/device/unpack_trace.h"
#include "host/trace/vulkan/binding_set.h"
#include "host/trace/vulkan/buffer.h"
#include "host/trace/vulkan/device.h"
#include "spirv/replay.h"

namespace candela::device {
namespace {

// Maximum number of segments of the single invocation in a dispatch: some milliseconds, even if a segment tests
// thousands of primitives.
constexpr std::uint32_t kSegmentsPerDispatch = 64;

// Returns the state of a path of this sample that has not started.
gpu::PathState stateBefore(const render::PixelSample& sample) {
  gpu::PathState state{};
  state.radianceSample.w = sample.index;
  return state;
}

}  // namespace

Kernel replayKernel() { return {render::KernelInUse::replay, {spirv::replay}, sizeof(gpu::PathState), nullptr}; }

render::PathTrace replayOnDevice(vulkan::Device& device, const vulkan::ComputePipeline& pipeline,
                                 const DeviceScene& scene, const render::PixelSample& sample, std::uint32_t maxDepth,
                                 const LoopBudget& budget, render::RenderStatistics& statistics) {
  vulkan::Buffer state(device, sizeof(gpu::PathState), vulkan::Usage::storage);
  vulkan::Buffer noFilm(device, sizeof(gpu::FilmRows), vulkan::Usage::storage);
  vulkan::Buffer results(device, sizeof(gpu::Counters) + sizeof(gpu::TracedSample), vulkan::Usage::storage);
  const vulkan::BindingSet bindings(pipeline,
                                    {&scene.rows(), &state, &noFilm, &results, &scene.texels(), &scene.uniforms()});
  const gpu::PathState before = stateBefore(sample);
  state.upload(std::as_bytes(std::span(&before, 1)));
  results.fill(0);

  gpu::DispatchConstants constants{};
  constants.regionOrigin = {sample.x, sample.y};
  constants.regionSize = {1, 1};
  constants.maxSegments = std::min(kSegmentsPerDispatch, budget.maxSegments);
  constants.maxIterations = budget.maxIterations;
  gpu::Counters counters{};
  // Each dispatch traces a segment at least, and a path has no more than `maxDepth`.
  for (std::uint32_t i = 0; counters.finishedSamples == 0 && counters.truncated == 0; ++i) {
    if (i == maxDepth)
      throw DeviceLostError(fmt::format("{} ({}) reports success, but does not trace the sample to its end",
                                        device.info().name, device.info().driver));
    device.run([&](vulkan::CommandRecorder& recorder) {
      recorder.dispatch(pipeline, bindings, std::as_bytes(std::span(&constants, 1)), {1, 1, 1});
    });
    results.download(std::as_writable_bytes(std::span(&counters, 1)));
  }
  statistics.truncated += counters.truncated;
  const auto rows = std::make_unique<gpu::TracedSample>();
  results.download(std::as_writable_bytes(std::span(rows.get(), 1)), sizeof counters);
  return unpackTrace(*rows);
}

}  // namespace candela::device

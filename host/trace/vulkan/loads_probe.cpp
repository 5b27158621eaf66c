// Measures how fast a device reads records through each type of buffer.
#include "host/trace/vulkan/loads_probe.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "host/trace/vulkan/binding_set.h"
#include "host/trace/vulkan/buffer.h"
#include "host/trace/vulkan/compute_pipeline.h"
#include "host/trace/vulkan/device.h"
#include "spirv/loads_probe.h"

namespace candela::vulkan {
namespace {

constexpr std::uint32_t kRows = 8192;  // 128 KiB, a power of two
constexpr std::uint32_t kWorkgroups = 32, kWorkgroupSize = 64;
constexpr int kRuns = 8;  // the first compiles the kernel

}  // namespace

LoadTimes probeLoads(Device& device) {
  Buffer rows(device, kRows * 16, Usage::storage | Usage::uniformTexel);
  rows.fill(0x9e3779b9u);
  Buffer results(device, std::uint64_t{kWorkgroups} * kWorkgroupSize * 4, Usage::storage);
  LoadTimes times{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  struct Kind {
    ComputePipeline pipeline;
    BindingSet bindings;
    double* seconds;
  };
  std::vector<Kind> kinds;
  for (double* const seconds : {&times.texel, &times.storage}) {
    using enum BindingKind;
    const ComputePipeline pipeline(device, spirv::loads_probe,
                                   {.bindings = {storageBuffer, uniformTexelBuffer, storageBuffer},
                                    .specialisations = {{0, seconds == &times.texel}}});
    kinds.push_back({pipeline, BindingSet(pipeline, {&rows, &rows, &results}), seconds});
  }
  for (int run = 0; run < kRuns; ++run) {
    for (const Kind& kind : kinds) {
      const double seconds = device.run(
          [&](CommandRecorder& recorder) { recorder.dispatch(kind.pipeline, kind.bindings, {}, {.x = kWorkgroups}); });
      if (run > 0) *kind.seconds = std::min(*kind.seconds, seconds);
    }
  }
  return times;
}

}  // namespace candela::vulkan

// Measures the number of loop iterations after which a device stops an invocation.
#include "host/trace/vulkan/loop_limit.h"

#include <array>

#include "host/trace/vulkan/binding_set.h"
#include "host/trace/vulkan/buffer.h"
#include "host/trace/vulkan/compute_pipeline.h"
#include "host/trace/vulkan/device.h"
#include "spirv/loop_probe.h"

namespace candela::vulkan {
namespace {

constexpr std::uint32_t kRequestedIterations = 1u << 17;

/// The buffer of shaders/loop_probe.comp.
struct ProbeData {
  std::uint32_t requested = 0;
  std::uint32_t executed = 0;
  std::uint32_t state = 0;
  std::uint32_t padding = 0;
};

}  // namespace

std::uint32_t probeLoopLimit(Device& device) {
  std::array<ProbeData, 1> data{ProbeData{.requested = kRequestedIterations}};
  Buffer buffer(device, sizeof data, Usage::storage);
  buffer.upload(std::as_bytes(std::span(data)));
  const ComputePipeline pipeline(device, spirv::loop_probe, {.bindings = {BindingKind::storageBuffer}});
  const BindingSet bindings(pipeline, {&buffer});
  device.run([&](CommandRecorder& recorder) { recorder.dispatch(pipeline, bindings, {}, {}); });
  buffer.download(std::as_writable_bytes(std::span(data)));
  return data[0].executed >= kRequestedIterations ? kUnlimitedIterations : data[0].executed;
}

}  // namespace candela::vulkan

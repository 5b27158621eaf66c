// Runs a leaf function's small shader over an array.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "host/trace/vulkan/binding_set.h"
#include "host/trace/vulkan/buffer.h"
#include "host/trace/vulkan/compute_pipeline.h"
#include "tests/trace/vulkan_support/test_device.h"

namespace candela::device {

/// Runs push[0] lanes, 64 a workgroup, on `inputs`; both push constants are given. Returns what they wrote.
template <typename Output, typename Input>
std::vector<Output> runLeaf(std::span<const std::uint32_t> spirv, const std::vector<Input>& inputs, std::size_t outputs,
                            std::array<std::uint32_t, 2> push,
                            std::vector<vulkan::Specialisation> specialisations = {}) {
  vulkan::Device device = openTestDevice();
  const vulkan::ComputePipeline pipeline(device, spirv,
                                         {.bindings = {2, vulkan::BindingKind::storageBuffer},
                                          .pushConstantBytes = sizeof push,
                                          .specialisations = std::move(specialisations)});
  // Memory that the host maps: copies through staging would take most of the time of a test on a discrete GPU.
  constexpr vulkan::Usage kUsage = vulkan::Usage::storage | vulkan::Usage::readback;
  vulkan::Buffer in(device, inputs.size() * sizeof(Input), kUsage);
  vulkan::Buffer out(device, outputs * sizeof(Output), kUsage);
  in.upload(std::as_bytes(std::span(inputs)));
  const vulkan::BindingSet bindings(pipeline, {&in, &out});
  device.run([&](vulkan::CommandRecorder& recorder) {
    recorder.dispatch(pipeline, bindings, std::as_bytes(std::span(push)), {.x = (push[0] + 63) / 64});
  });
  std::vector<Output> result(outputs);
  out.download(std::as_writable_bytes(std::span(result)));
  return result;
}

}  // namespace candela::device

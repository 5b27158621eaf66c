// Runs shaders/conformance/identities.comp.
#include "host/drivers/conformance/identity_run.h"

#include <fmt/format.h>

#include <array>
#include <bit>

#include "host/drivers/conformance/memory_run.h"
#include "host/drivers/conformance/shader_run.h"
#include "spirv/identities.h"

namespace candela::conformance {
namespace {

constexpr vulkan::GroupCount kGroups{3, 2, 2};
constexpr std::uint32_t kCounts = 0;  // binding

/// The outputs and the number of times that each was written.
struct Identities {
  WordList counts, outputs;
};

Identities dispatchIdentities(const GroupShape& shape, vulkan::Device& device, std::uint32_t count) {
  const std::array<std::uint32_t, 2> push{count, 0};
  const vulkan::ComputePipeline pipeline = create(pipelineOf(shape), device);
  vulkan::Buffer counts(device, count * sizeof(std::uint32_t), vulkan::Usage::storage);
  vulkan::Buffer outputs(device, count * sizeof(Words), vulkan::Usage::storage);
  counts.fill(0);
  outputs.fill(0);
  const vulkan::BindingSet bindings(pipeline, {&counts, &outputs});
  device.run([&](vulkan::CommandRecorder& recorder) {
    recorder.dispatch(pipeline, bindings, std::as_bytes(std::span(push)), kGroups);
  });
  return {wordsOf(counts), wordsOf(outputs)};
}

Words expectedIdentity(const GroupShape& shape, std::uint32_t x, std::uint32_t y, std::uint32_t z,
                       std::uint32_t subgroupSize) {
  const std::uint32_t local = (z % shape.z * shape.y + y % shape.y) * shape.x + x % shape.x;
  return {x / shape.x | y / shape.y << 8 | z / shape.z << 16, local, shape.x | shape.y << 11 | shape.z << 22,
          subgroupSize};
}

}  // namespace

bool hasShape(const vulkan::DeviceInfo& device, const GroupShape& shape) {
  return shape.x <= device.maxWorkgroupSize[0] && shape.y <= device.maxWorkgroupSize[1] &&
         shape.z <= device.maxWorkgroupSize[2] && shape.x * shape.y * shape.z <= device.maxWorkgroupInvocations;
}

std::string missingShape(const vulkan::DeviceInfo& device, const GroupShape& shape) {
  return fmt::format("workgroups of {}x{}x{} invocations (the maximum is {} invocations, {}x{}x{})", shape.x, shape.y,
                     shape.z, device.maxWorkgroupInvocations, device.maxWorkgroupSize[0], device.maxWorkgroupSize[1],
                     device.maxWorkgroupSize[2]);
}

bool hasSubgroupSize(const vulkan::DeviceInfo& device, std::uint32_t size) {
  return device.minSubgroupSize > 0 && size >= device.minSubgroupSize && size <= device.maxSubgroupSize;
}

std::string missingSubgroupSize(const vulkan::DeviceInfo& device, std::uint32_t size) {
  if (device.minSubgroupSize == 0) return "VK_EXT_subgroup_size_control for compute shaders";
  return fmt::format("subgroups of {} invocations in compute shaders (minimum {}, maximum {})", size,
                     device.minSubgroupSize, device.maxSubgroupSize);
}

CasePipeline pipelineOf(const GroupShape& shape) {
  return pipelineOf({.spirv = spirv::identities, .specialisations = {{0, shape.x}, {1, shape.y}, {2, shape.z}}});
}

Finding runIdentities(const GroupShape& shape, vulkan::Device& device, std::uint32_t subgroupSize) {
  const std::uint32_t width = kGroups.x * shape.x, height = kGroups.y * shape.y, depth = kGroups.z * shape.z;
  const Identities found = dispatchIdentities(shape, device, width * height * depth);
  constexpr std::array kNames{"workgroup", "local index", "workgroup size", "subgroup size"};
  Mismatches mismatches;
  for (std::uint32_t i = 0; i < width * height * depth; ++i) {
    const std::uint32_t x = i % width, y = i / width % height, z = i / width / height;
    const Words expected = expectedIdentity(shape, x, y, z, subgroupSize);
    mismatches.expect(fmt::format("runs of invocation {},{},{}", x, y, z), {kCounts, i}, 1, found.counts[i]);
    for (std::size_t k = 0; k < expected.size(); ++k) {
      mismatches.expect(fmt::format("invocation {},{},{}, {}", x, y, z, kNames[k]), outputPosition(i, k), expected[k],
                        found.outputs[4 * i + k]);
    }
  }
  return mismatches.finding();
}

}  // namespace candela::conformance

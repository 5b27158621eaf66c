// The built-in variables that identify invocations, and the sizes that a device supports.
#pragma once
#include <array>
#include <cstdint>
#include <string>

#include "host/drivers/conformance/case_pipeline.h"
#include "host/trace/vulkan/device.h"

namespace candela::conformance {

/// The size of a workgroup in invocations.
struct GroupShape {
  std::uint32_t x, y, z;
};

/// The sizes for which there are cases.
inline constexpr std::array<std::uint32_t, 5> kSubgroupSizes{4, 8, 16, 32, 64};

bool hasShape(const vulkan::DeviceInfo& device, const GroupShape& shape);
/// Returns the missing feature, with the limits of the device: "the device lacks ..." is a sentence.
std::string missingShape(const vulkan::DeviceInfo& device, const GroupShape& shape);

/// Returns whether pipelines may require the subgroup size.
bool hasSubgroupSize(const vulkan::DeviceInfo& device, std::uint32_t size);
/// Returns the missing feature, VK_EXT_subgroup_size_control or the size, as missingShape() does.
std::string missingSubgroupSize(const vulkan::DeviceInfo& device, std::uint32_t size);

CasePipeline pipelineOf(const GroupShape& shape);
/// Runs 3 x 2 x 2 workgroups of this shape. Each invocation must run once, with the right workgroup, local index and
/// sizes.
Finding runIdentities(const GroupShape& shape, vulkan::Device& device, std::uint32_t subgroupSize);

}  // namespace candela::conformance

// The filter of docs/denoising.md on a Vulkan device.
#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "host/trace/denoise/pixel_statistics.h"
#include "host/trace/vulkan/device.h"

namespace candela::denoise {

/// The division of the work, which does not change a bit of the result.
struct FilterDivision {
  std::uint64_t maxBandBytes = std::uint64_t{64} << 20;  ///< of device memory, unless one row takes more
  std::uint32_t maxDispatchPixels = 1u << 16;            ///< unless one row has more; few, so that a dispatch is short
};

/// Returns the result of filterByReference(), computed by the device in single precision: within
/// kDeviceTolerance * (1 + value). Throws as vulkan::Device::run() does.
std::vector<glm::vec3> filterOnDevice(vulkan::Device& device, const PixelStatistics& statistics,
                                      const FilterDivision& division = {});

inline constexpr double kDeviceTolerance = 1e-4;

}  // namespace candela::denoise

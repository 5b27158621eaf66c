// Conversion of values to 16-byte records, which are called rows in names.
#pragma once
#include <bit>
#include <cstdint>
#include <vector>

#include "shaders/shared/scene_rows.h"

namespace candela::flatten {

using Rows = std::vector<gpu::uvec4>;

inline std::uint32_t rowCount(const Rows& rows) { return static_cast<std::uint32_t>(rows.size()); }

inline std::uint32_t floatBits(double value) { return std::bit_cast<std::uint32_t>(static_cast<float>(value)); }

inline gpu::uvec4 row(const glm::dvec3& xyz, std::uint32_t w) {
  return {floatBits(xyz.x), floatBits(xyz.y), floatBits(xyz.z), w};
}

inline gpu::uvec4 row(const glm::dvec3& xyz, double w) { return row(xyz, floatBits(w)); }

}  // namespace candela::flatten

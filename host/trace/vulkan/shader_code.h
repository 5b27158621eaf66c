// A shader as a driver gets it; this header uses no Vulkan type.
#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace candela::vulkan {

/// The value of a 32-bit specialisation constant; bool: 0 or 1; float: its bits.
struct Specialisation {
  std::uint32_t id = 0;
  std::uint32_t value = 0;
  bool operator==(const Specialisation&) const = default;
};

struct ShaderCode {
  std::vector<std::uint32_t> words;               ///< SPIR-V
  std::vector<Specialisation> specialisations{};  ///< values that the driver sets; constants without one have defaults
};

/// Makes the code for the driver from a module and the values of its specialisation constants.
using PrepareShader = std::function<ShaderCode(std::span<const std::uint32_t> spirv,
                                               const std::vector<Specialisation>& specialisations)>;

}  // namespace candela::vulkan

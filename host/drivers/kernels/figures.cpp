// Translates the names that drivers give their statistics.
#include "host/drivers/kernels/figures.h"

#include <algorithm>
#include <string_view>

namespace candela::kernels {
namespace {

/// A name of a statistic.
struct Name {
  std::string_view name;
  std::optional<double> Figures::*member;
};

constexpr std::array kNames{
    // RADV
    Name{"VGPRs", &Figures::registers},
    Name{"Spilled SGPRs", &Figures::spillsToRegisters},
    Name{"Spilled VGPRs", &Figures::spillsToMemory},
};

}  // namespace

Figures normalise(const vulkan::Executable& executable) {
  Figures figures;
  for (const auto& [name, value] : executable.statistics) {
    const auto found = std::ranges::find(kNames, name, &Name::name);
    if (found != kNames.end()) figures.*found->member = value;
  }
  return figures;
}

std::optional<double> invocationsInFlight(const vulkan::Executable& executable, std::uint32_t minSubgroupSize) {
  for (const auto& [name, value] : executable.statistics) {
    if (name == "Subgroups per SIMD") return value * minSubgroupSize;
  }
  return std::nullopt;
}

}  // namespace candela::kernels

// Translates the names that drivers give their statistics.
#include "host/drivers/kernels/figures.h"

#include <algorithm>

namespace candela::kernels {
namespace {

using Statistic = vulkan::ExecutableStatistic;

struct Name {
  std::string_view name;
  std::optional<double> Figures::*member;
};

// No two drivers use one name for different figures. Mesa lists the names of its drivers in src/util/shader_stats.xml.
constexpr std::array kNames{
    Name{"Spilled VGPRs", &Figures::spillsToMemory},     // RADV
    Name{"Spills to memory", &Figures::spillsToMemory},  // NVK
    Name{"STP Count", &Figures::spillsToMemory},         // Turnip: stores to private memory
    Name{"Spills", &Figures::spillsToMemory},            // Honeykrisp, ANV, PanVK
    Name{"Spill Count", &Figures::spillsToMemory},       // ANV before Mesa 26
    Name{"TMU Spills", &Figures::spillsToMemory},        // V3DV
    Name{"Spilled SGPRs", &Figures::spillsToRegisters},  // RADV
    Name{"Spills to reg", &Figures::spillsToRegisters},  // NVK
    Name{"VGPRs", &Figures::registers},                  // RADV
    Name{"Number of GPRs", &Figures::registers},         // NVK
    Name{"Registers used", &Figures::registers},         // Turnip: of four components; PanVK
    Name{"GPRs", &Figures::registers},                   // Honeykrisp: of 16 bits
    Name{"Max live registers", &Figures::registers},     // ANV
    Name{"Register Count", &Figures::registers},         // NVIDIA
    Name{"numUsedVgprs", &Figures::registers},           // AMD
    Name{"Instructions", &Figures::instructions},        // RADV, Honeykrisp, ANV, PanVK
    Name{"Instruction count", &Figures::instructions},   // NVK
    Name{"Instruction Count", &Figures::instructions},   // Turnip, V3DV, ANV before Mesa 26
    Name{"Latency", &Figures::cycles},                   // RADV
    Name{"Static cycle count", &Figures::cycles},        // NVK
    Name{"Cycles", &Figures::cycles},                    // ANV, PanVK
    Name{"Cycle Count", &Figures::cycles},               // ANV before Mesa 26
    Name{"Code size", &Figures::codeBytes},              // RADV, NVK, Turnip, Honeykrisp, ANV, PanVK
    Name{"Binary Size", &Figures::codeBytes},            // NVIDIA
};

double numberIn(const Statistic& statistic) {
  return std::visit([](auto value) { return static_cast<double>(value); }, statistic.value);
}

const Statistic* find(const vulkan::Executable& executable, std::string_view name) {
  const auto found = std::ranges::find(executable.statistics, name, &Statistic::name);
  return found == executable.statistics.end() ? nullptr : &*found;
}

}  // namespace

Figures normalise(const vulkan::Executable& executable, std::string_view driverName) {
  Figures figures;
  for (const auto& [name, member] : kNames) {
    if (const Statistic* const statistic = find(executable, name)) figures.*member = numberIn(*statistic);
  }
  if (figures.codeBytes && driverName.starts_with("turnip")) *figures.codeBytes *= 4;  // it counts words
  return figures;
}

std::optional<double> invocationsInFlight(const vulkan::Executable& executable, std::uint32_t minSubgroupSize) {
  // RADV counts a subgroup of 64 as two where the device has subgroups of 32, too.
  if (const Statistic* const found = find(executable, "Subgroups per SIMD")) return numberIn(*found) * minSubgroupSize;
  for (const std::string_view name : {"Max warps/SM", "Max Waves Per Core"}) {
    if (const Statistic* const found = find(executable, name)) return numberIn(*found) * executable.subgroupSize;
  }
  if (const Statistic* const found = find(executable, "Threads")) return numberIn(*found);
  return std::nullopt;
}

}  // namespace candela::kernels

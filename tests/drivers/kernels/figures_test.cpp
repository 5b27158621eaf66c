// Statistics as drivers reported them, and the figures that they become.
#include "host/drivers/kernels/figures.h"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

namespace candela::kernels {
namespace {

using vulkan::Executable;

struct Count {
  const char* name;
  std::uint64_t value;
};

Executable executableOf(std::uint32_t subgroupSize, const std::vector<Count>& counts) {
  Executable executable{"compute", subgroupSize, {}};
  for (const auto& [name, value] : counts) executable.statistics.push_back({name, value});
  return executable;
}

// The megakernel for ToyCar and Mesa 26.2.6, without the statistics that are no figures.
const Executable kRadv = executableOf(64, {{"Driver pipeline hash", 9764575830090882764u},
                                           {"SGPRs", 108},
                                           {"VGPRs", 256},
                                           {"Spilled SGPRs", 17},
                                           {"Spilled VGPRs", 3},
                                           {"Code size", 47540},
                                           {"Scratch size", 0},
                                           {"Subgroups per SIMD", 4},
                                           {"Instructions", 8190},
                                           {"Latency", 183768},
                                           {"Inverse Throughput", 91884},
                                           {"Pre-Sched VGPRs", 205}});
const Executable kNvk = executableOf(32, {{"Instruction count", 12318},
                                          {"Static cycle count", 1271415},
                                          {"Max warps/SM", 8},
                                          {"Spills to memory", 918},
                                          {"Fills from memory", 652},
                                          {"Spills to reg", 148},
                                          {"Fills from reg", 137},
                                          {"Code size", 197088},
                                          {"Number of GPRs", 255}});
const Executable kTurnip = executableOf(64, {{"Max Waves Per Core", 4},
                                             {"Instruction Count", 15020},
                                             {"Code size", 22496},
                                             {"Registers used", 48},
                                             {"Half-registers used", 0},
                                             {"STP Count", 221},
                                             {"LDP Count", 363},
                                             {"Preamble Instruction Count", 76}});
const Executable kHoneykrisp = executableOf(32, {{"Instructions", 33874},
                                                 {"ALU", 29032},
                                                 {"Code size", 216206},
                                                 {"GPRs", 255},
                                                 {"Threads", 384},
                                                 {"Spills", 1052},
                                                 {"Fills", 1240},
                                                 {"Preamble instructions", 44}});

TEST_CASE("RADV: spills of VGPRs are to memory, those of SGPRs to registers") {
  const Figures figures = normalise(kRadv, "radv");
  CHECK(figures.spillsToMemory == 3);
  CHECK(figures.spillsToRegisters == 17);
  CHECK(figures.registers == 256);
  CHECK(figures.instructions == 8190);
  CHECK(figures.cycles == 183768);
  CHECK(figures.codeBytes == 47540);
  CHECK_FALSE(figures.occupancy);
}

TEST_CASE("NVK: spills to memory and to registers are apart") {
  const Figures figures = normalise(kNvk, "NVK");
  CHECK(figures.spillsToMemory == 918);
  CHECK(figures.spillsToRegisters == 148);
  CHECK(figures.registers == 255);
  CHECK(figures.instructions == 12318);
  CHECK(figures.cycles == 1271415);
  CHECK(figures.codeBytes == 197088);
}

TEST_CASE("Turnip: stores to private memory are spills, and words of code become bytes") {
  const Figures figures = normalise(kTurnip, "turnip Mesa driver");
  CHECK(figures.spillsToMemory == 221);
  CHECK_FALSE(figures.spillsToRegisters);
  CHECK(figures.registers == 48);
  CHECK(figures.instructions == 15020);
  CHECK_FALSE(figures.cycles);
  CHECK(figures.codeBytes == 4 * 22496);
}

TEST_CASE("Honeykrisp: it estimates the cycles of units, not those of a kernel") {
  const Figures figures = normalise(kHoneykrisp, "Honeykrisp");
  CHECK(figures.spillsToMemory == 1052);
  CHECK(figures.registers == 255);
  CHECK(figures.instructions == 33874);
  CHECK_FALSE(figures.cycles);
  CHECK(figures.codeBytes == 216206);
}

TEST_CASE("statistics of every format are numbers, and unknown ones are no figures") {
  const Executable executable{
      "compute", 16, {{"Cycles", 2.5}, {"Spills", std::int64_t{-1}}, {"Instructions", true}, {"Other", 1.0}}};
  const Figures figures = normalise(executable, "panvk");
  CHECK(figures.cycles == 2.5);
  CHECK(figures.spillsToMemory == -1);
  CHECK(figures.instructions == 1);
  CHECK_FALSE(figures.registers);
}

TEST_CASE("invocations in flight do not depend on the unit in which a driver counts") {
  CHECK(invocationsInFlight(kRadv, 32) == 4 * 32);
  CHECK(invocationsInFlight(kNvk, 32) == 8 * 32);
  CHECK(invocationsInFlight(kTurnip, 64) == 4 * 64);
  CHECK(invocationsInFlight(kHoneykrisp, 32) == 384);
  CHECK_FALSE(invocationsInFlight(executableOf(32, {{"Instructions", 1}}), 32));
}

TEST_CASE("RADV: a kernel of equal registers has equally many invocations in flight with both subgroup sizes") {
  // 128 VGPRs of 1024 on a SIMD unit with 32 lanes, as navi21 reported for subgroups of 64 and of 32.
  const Executable wide = executableOf(64, {{"VGPRs", 128}, {"Subgroups per SIMD", 8}});
  const Executable narrow = executableOf(32, {{"VGPRs", 128}, {"Subgroups per SIMD", 8}});
  CHECK(invocationsInFlight(wide, 32) == invocationsInFlight(narrow, 32));
  // Before GFX10, every subgroup has 64 invocations.
  CHECK(invocationsInFlight(executableOf(64, {{"Subgroups per SIMD", 10}}), 64) == 640);
}

}  // namespace
}  // namespace candela::kernels

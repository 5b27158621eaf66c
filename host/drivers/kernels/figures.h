// The figures of a compiled kernel, under names that are the same for all drivers.
#pragma once
#include <array>
#include <optional>
#include <string_view>

#include "host/trace/vulkan/pipeline_report.h"

namespace candela::kernels {

/// Absent: the driver does not report it.
struct Figures {
  std::optional<double> occupancy;          ///< invocations in flight, as a fraction of the device's maximum
  std::optional<double> spillsToMemory;     ///< in the driver's unit: registers or instructions
  std::optional<double> spillsToRegisters;  ///< to registers of another kind, in the driver's unit
  std::optional<double> registers;          ///< of an invocation, in the driver's unit
  std::optional<double> instructions;
  std::optional<double> cycles;  ///< the driver's estimate
  std::optional<double> codeBytes;
  std::optional<double> spirvBytes;
  std::optional<double> cacheBytes;
  std::optional<double> compileSeconds;
};

enum class Better { higher, lower, notJudged };

struct FigureInfo {
  std::optional<double> Figures::*member;
  const char* key;    ///< in JSON documents
  const char* title;  ///< of the column of a table
  Better better;
  bool isOfAllDrivers;  ///< the unit is the same for all drivers
};

inline constexpr std::array kFigures{
    FigureInfo{&Figures::occupancy, "occupancyFraction", "occupancy", Better::higher, true},
    FigureInfo{&Figures::spillsToMemory, "spillsToMemory", "memory spills", Better::lower, false},
    FigureInfo{&Figures::spillsToRegisters, "spillsToRegisters", "register spills", Better::lower, false},
    FigureInfo{&Figures::registers, "registers", "registers", Better::notJudged, false},
    FigureInfo{&Figures::instructions, "instructions", "instructions", Better::lower, false},
    FigureInfo{&Figures::cycles, "cycles", "cycles", Better::lower, false},
    FigureInfo{&Figures::codeBytes, "codeBytes", "code bytes", Better::notJudged, false},
    FigureInfo{&Figures::spirvBytes, "spirvBytes", "SPIR-V bytes", Better::notJudged, true},
    FigureInfo{&Figures::cacheBytes, "cacheBytes", "cache bytes", Better::notJudged, false},
    FigureInfo{&Figures::compileSeconds, "compileSeconds", "ms to compile", Better::notJudged, true}};

/// Returns the figures in what a driver (vulkan::DeviceInfo::driverName) reports about an executable, without
/// occupancy.
Figures normalise(const vulkan::Executable& executable, std::string_view driverName);

/// Returns the number of invocations that a multiprocessor of the device, in the driver's sense, has in flight.
/// `minSubgroupSize` is that of the device. Empty: the driver does not report it.
std::optional<double> invocationsInFlight(const vulkan::Executable& executable, std::uint32_t minSubgroupSize);

}  // namespace candela::kernels

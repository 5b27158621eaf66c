// The groups of rows of the option table, and the sets of commands and ranges that several groups share.
#pragma once
#include <limits>
#include <vector>

#include "host/app/cli/option_table.h"

namespace candela::cli {

inline constexpr unsigned kRender = static_cast<unsigned>(Command::render);
inline constexpr unsigned kDevices = static_cast<unsigned>(Command::devices);
inline constexpr unsigned kVerify = static_cast<unsigned>(Command::verify);
inline constexpr unsigned kBoxes = static_cast<unsigned>(Command::boxes);
inline constexpr unsigned kView = static_cast<unsigned>(Command::view);
inline constexpr unsigned kLayered = kRender | kView | static_cast<unsigned>(Command::kernels);
inline constexpr unsigned kTracingButVerify = commandsWith<TracingArguments> & ~kVerify;
inline constexpr unsigned kSurrounding = commandsWith<SceneArguments> & ~kBoxes;

inline constexpr std::uint32_t kAnySize = std::numeric_limits<std::uint32_t>::max();  ///< the range is checked later

std::vector<Option> imageOptions();
std::vector<Option> sceneFileOptions();
std::vector<Option> sequenceOptions();
std::vector<Option> executionOptions();
std::vector<Option> outputOptions();
std::vector<Option> filmOptions();
std::vector<Option> comparisonOptions();
std::vector<Option> verificationOptions();
std::vector<Option> conformanceOptions();
std::vector<Option> captureOptions();
std::vector<Option> explanationOptions();
std::vector<Option> benchmarkOptions();
std::vector<Option> kernelOptions();
std::vector<Option> tuningOptions();
std::vector<Option> generationOptions();
std::vector<Option> viewingOptions();
std::vector<Option> generalOptions();

}  // namespace candela::cli

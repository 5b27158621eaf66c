// The groups of rows of the option table, and the sets of commands and ranges that several groups share.
#pragma once
#include <limits>
#include <vector>

#include "host/cli/option_table.h"

namespace candela::cli {

inline constexpr unsigned kRender = static_cast<unsigned>(Command::render);
inline constexpr unsigned kDevices = static_cast<unsigned>(Command::devices);
inline constexpr unsigned kCheck = static_cast<unsigned>(Command::check);
inline constexpr unsigned kCompare = static_cast<unsigned>(Command::compare);
inline constexpr unsigned kGenerate = static_cast<unsigned>(Command::generate);
inline constexpr unsigned kBench = static_cast<unsigned>(Command::bench);
inline constexpr unsigned kVerify = static_cast<unsigned>(Command::verify);
inline constexpr unsigned kBoxes = static_cast<unsigned>(Command::boxes);
inline constexpr unsigned kExplain = static_cast<unsigned>(Command::explain);
inline constexpr unsigned kTune = static_cast<unsigned>(Command::tune);
inline constexpr unsigned kDoctor = static_cast<unsigned>(Command::doctor);
inline constexpr unsigned kFilm = static_cast<unsigned>(Command::film);
inline constexpr unsigned kMerge = static_cast<unsigned>(Command::merge);
inline constexpr unsigned kConformance = static_cast<unsigned>(Command::conformance);
inline constexpr unsigned kDenoise = static_cast<unsigned>(Command::denoise);
inline constexpr unsigned kReport = static_cast<unsigned>(Command::report);
inline constexpr unsigned kCapture = static_cast<unsigned>(Command::capture);
inline constexpr unsigned kView = static_cast<unsigned>(Command::view);
inline constexpr unsigned kTracing = kRender | kCompare | kBench | kVerify | kExplain | kCapture | kView;
inline constexpr unsigned kReadingScenes = kTracing | kCheck | kBoxes | kTune;
inline constexpr unsigned kSurrounding = kTracing | kCheck | kTune;
inline constexpr unsigned kReporting = kRender | kDevices | kCheck | kCompare | kBench | kVerify | kExplain | kTune |
                                       kDoctor | kFilm | kMerge | kConformance | kView;
inline constexpr unsigned kAll = kReporting | kGenerate | kBoxes | kReport | kCapture | kDenoise;

inline constexpr std::uint32_t kAnySize = std::numeric_limits<std::uint32_t>::max();  ///< the range is checked later

std::vector<Option> imageOptions();
std::vector<Option> sceneFileOptions();
std::vector<Option> executionOptions();
std::vector<Option> outputOptions();
std::vector<Option> filmOptions();
std::vector<Option> comparisonOptions();
std::vector<Option> verificationOptions();
std::vector<Option> conformanceOptions();
std::vector<Option> captureOptions();
std::vector<Option> explanationOptions();
std::vector<Option> benchmarkOptions();
std::vector<Option> tuningOptions();
std::vector<Option> generationOptions();
std::vector<Option> viewingOptions();
std::vector<Option> generalOptions();

}  // namespace candela::cli

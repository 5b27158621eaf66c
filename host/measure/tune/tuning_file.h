// Stores results of tuning in the user's cache, in one file per device, driver and set of kernels.
#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "host/job/cache/device_key.h"
#include "host/measure/tune/dimensions.h"

namespace candela::tune {

struct Tuning {
  Candidate candidate;
  std::string date;  ///< "2026-01-31T12:00:00Z"
};

struct TuningLookup {
  std::optional<Tuning> tuning;  ///< empty if there is no result, or if there is a problem
  std::string problem;           ///< why the file must not be used; completes "FILE is ignored: "
};

/// Reads a result. Whatever the file contains, the result is a candidate of this program that the device supports.
TuningLookup readTuning(const std::filesystem::path& file, const cache::DeviceKey& key, const vulkan::DeviceInfo& info);

/// Throws FileError if writeTuning() could not write the file, or if it exists and is not a regular file. Creates
/// nothing.
void requireTuningFile(const std::filesystem::path& file);
/// Creates or replaces the file, and creates its folder. Throws FileError.
void writeTuning(const std::filesystem::path& file, const cache::DeviceKey& key, const Tuning& tuning);

/// Returns the current time in the notation of Tuning.
std::string dateNow();

}  // namespace candela::tune

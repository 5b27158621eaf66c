// Stores results of tuning in the user's cache, in one file per device, driver and set of kernels.
#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "host/tune/dimensions.h"

namespace candela::tune {

/// The conditions for which a choice is valid. If any of them changes, another choice may be faster.
struct TuningKey {
  std::string device;
  std::string driver;
  std::string driverVersion;
  std::string pipelineCacheUuid;
  std::string kernels;  ///< hash of the code of all kernels

  bool operator==(const TuningKey&) const = default;
};

/// Returns the key of a device with the kernels of this program.
TuningKey keyOf(const vulkan::DeviceInfo& info);

struct Tuning {
  Candidate candidate;
  std::string date;  ///< "2026-01-31T12:00:00Z"
};

/// Returns the folder of these files: CANDELA_CACHE_DIR, else candela in XDG_CACHE_HOME (if that is absolute), else
/// .cache/candela in HOME; nothing if none of them is set.
std::optional<std::filesystem::path> cacheFolder();

/// Returns the name of the file in the folder, a hash of the key.
std::string fileNameOf(const TuningKey& key);

struct TuningLookup {
  std::optional<Tuning> tuning;  ///< empty if there is no result, or if there is a problem
  std::string problem;           ///< why the file must not be used; completes "FILE is ignored: "
};

/// Reads a result. Whatever the file contains, the result is a candidate of this program that the device supports.
TuningLookup readTuning(const std::filesystem::path& file, const TuningKey& key, const vulkan::DeviceInfo& info);

/// Throws FileError if writeTuning() could not write the file, or if it exists and is not a regular file. Creates
/// nothing.
void requireTuningFile(const std::filesystem::path& file);
/// Creates or replaces the file, and creates its folder. Throws FileError.
void writeTuning(const std::filesystem::path& file, const TuningKey& key, const Tuning& tuning);

/// Returns the current time in the notation of Tuning.
std::string dateNow();

}  // namespace candela::tune

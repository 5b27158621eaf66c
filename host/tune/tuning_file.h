// Where the outcome of tuning is kept: a file for each device, driver and set of kernels, in the user's cache.
#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "host/tune/dimensions.h"

namespace candela::tune {

/// What a choice holds for. Whatever of it changes may make another one faster.
struct TuningKey {
  std::string device;
  std::string driver;
  std::string driverVersion;
  std::string pipelineCacheUuid;
  std::string kernels;  ///< hash of their code

  bool operator==(const TuningKey&) const = default;
};

/// With the kernels of this program.
TuningKey keyOf(const vulkan::DeviceInfo& info);

struct Tuning {
  Candidate candidate;
  std::string date;  ///< "2026-01-31T12:00:00Z"
};

/// The folder of all such files: CANDELA_CACHE_DIR, else candela in XDG_CACHE_HOME (if that is absolute), else
/// .cache/candela in HOME; none if none of them is set.
std::optional<std::filesystem::path> cacheFolder();

/// Its name in the folder, a hash of the key.
std::string fileNameOf(const TuningKey& key);

struct TuningLookup {
  std::optional<Tuning> tuning;  ///< absent: nobody has tuned, or there is a problem
  std::string problem;           ///< why what is there must not be used; completes "FILE is ignored: "
};

/// Whatever the file may hold, what is returned is a candidate of this program's that the device has.
TuningLookup readTuning(const std::filesystem::path& file, const TuningKey& key, const vulkan::DeviceInfo& info);

/// Throws FileError if writeTuning() could not write there, or if a pipe or the like is in its place. Makes nothing.
void requireTuningFile(const std::filesystem::path& file);
/// Replaces the file, or makes it and its folder. Throws FileError.
void writeTuning(const std::filesystem::path& file, const TuningKey& key, const Tuning& tuning);

/// The present time as Tuning has it.
std::string dateNow();

}  // namespace candela::tune

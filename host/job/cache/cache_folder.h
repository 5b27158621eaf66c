// The folder of files that Candela can recreate: results of tuning and compiled pipelines.
#pragma once
#include <filesystem>
#include <optional>

namespace candela::cache {

/// Returns CANDELA_CACHE_DIR, else candela in XDG_CACHE_HOME (if that is absolute), else .cache/candela in HOME;
/// nothing if none of them is set. The folder need not exist.
std::optional<std::filesystem::path> cacheFolder();

}  // namespace candela::cache

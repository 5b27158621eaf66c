// Finds the cache folder by the rules of the XDG base directory specification.
#include "host/job/cache/cache_folder.h"

#include <string>

#include "host/base/environment.h"

namespace candela::cache {

namespace fs = std::filesystem;

std::optional<fs::path> cacheFolder() {
  if (const std::string own = environmentVariable("CANDELA_CACHE_DIR"); !own.empty()) return own;
  if (const fs::path caches = environmentVariable("XDG_CACHE_HOME"); caches.is_absolute()) return caches / "candela";
  if (const fs::path home = environmentVariable("HOME"); home.is_absolute()) return home / ".cache" / "candela";
  return std::nullopt;
}

}  // namespace candela::cache

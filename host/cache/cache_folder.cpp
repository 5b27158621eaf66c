// Finds the cache folder by the rules of the XDG base directory specification.
#include "host/cache/cache_folder.h"

#include <cstdlib>
#include <string>

namespace candela::cache {
namespace {

namespace fs = std::filesystem;

std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

}  // namespace

std::optional<fs::path> cacheFolder() {
  if (const std::string own = variable("CANDELA_CACHE_DIR"); !own.empty()) return own;
  if (const fs::path caches = variable("XDG_CACHE_HOME"); caches.is_absolute()) return caches / "candela";
  if (const fs::path home = variable("HOME"); home.is_absolute()) return home / ".cache" / "candela";
  return std::nullopt;
}

}  // namespace candela::cache

// The rules for the folder of caches.
#include "host/job/cache/cache_folder.h"

#include <catch2/catch.hpp>

#include "tests/trace/vulkan/environment_guard.h"

namespace candela::cache {

TEST_CASE("the cache folder is CANDELA_CACHE_DIR, else candela in XDG_CACHE_HOME, else .cache/candela in HOME") {
  const vulkan::EnvironmentGuard home("HOME", "/home/a");
  const vulkan::EnvironmentGuard caches("XDG_CACHE_HOME", "/caches");
  const vulkan::EnvironmentGuard own("CANDELA_CACHE_DIR", "own");
  CHECK(cacheFolder() == "own");
  const vulkan::EnvironmentGuard noOwn("CANDELA_CACHE_DIR", "");
  CHECK(cacheFolder() == "/caches/candela");
  const vulkan::EnvironmentGuard relative("XDG_CACHE_HOME", "caches");
  CHECK(cacheFolder() == "/home/a/.cache/candela");
  const vulkan::EnvironmentGuard noHome("HOME", "");
  CHECK_FALSE(cacheFolder());
}

}  // namespace candela::cache

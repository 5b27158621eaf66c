// The cache folder: absent, writable, not writable, with damaged files.
#include "host/drivers/doctor/caches.h"

#include <catch2/catch.hpp>

#include "host/drivers/doctor/resources.h"
#include "host/job/cache/device_key.h"
#include "tests/base/temporary_folder.h"
#include "tests/trace/vulkan/environment_guard.h"

namespace candela::doctor {

using Catch::Contains;
using vulkan::EnvironmentGuard;

TEST_CASE("a cache folder that can be created is ok, and is not created") {
  const TemporaryFolder folder;
  const EnvironmentGuard own("CANDELA_CACHE_DIR", (folder.path() / "a" / "b").string());
  const Checks checks = checkCaches(std::nullopt);
  REQUIRE(checks.size() == 1);
  CHECK(checks[0].status == Status::ok);
  CHECK_THAT(checks[0].text, Contains("is writable"));
  CHECK_FALSE(std::filesystem::exists(folder / "a"));
}

TEST_CASE("a file in place of the cache folder is a warning, since root may write anywhere else") {
  const TemporaryFolder folder;
  writeText(folder / "file", "");
  for (const char* name : {"file", "file/below"}) {
    const EnvironmentGuard own("CANDELA_CACHE_DIR", (folder / name).string());
    const Checks checks = checkCaches(std::nullopt);
    REQUIRE(checks.size() == 1);
    CHECK(checks[0].status == Status::warning);
    CHECK_THAT(checks[0].text, Contains("file is not a folder"));
    CHECK_THAT(checks[0].remedy, Contains("CANDELA_CACHE_DIR"));
  }
}

TEST_CASE("a folder in which no file can be created is a warning, whatever its permissions") {
  const EnvironmentGuard own("CANDELA_CACHE_DIR", "/proc/candela");
  const Checks checks = checkCaches(std::nullopt);
  REQUIRE(checks.size() == 1);
  CHECK(checks[0].status == Status::warning);
  CHECK_THAT(checks[0].text, Contains("no file can be created in /proc: "));
}

TEST_CASE("without a home there is no cache folder, which is a warning") {
  const EnvironmentGuard own("CANDELA_CACHE_DIR", "");
  const EnvironmentGuard caches("XDG_CACHE_HOME", "");
  const EnvironmentGuard home("HOME", "");
  const Checks checks = checkCaches(std::nullopt);
  REQUIRE(checks.size() == 1);
  CHECK(checks[0].status == Status::warning);
  CHECK_FALSE(checks[0].remedy.empty());
}

TEST_CASE("damaged files of a device are warnings that name them") {
  const TemporaryFolder folder;
  const EnvironmentGuard own("CANDELA_CACHE_DIR", folder.path().string());
  vulkan::DeviceInfo device;
  device.name = "made device";
  const Checks none = checkCaches(device);
  REQUIRE(none.size() == 3);
  for (const Check& check : none) CHECK(check.status == Status::ok);
  const cache::DeviceKey key = cache::keyOf(device);
  const std::vector<std::string> names{cache::fileNameOf("pipelines", key, "bin"),
                                       cache::fileNameOf("tune", key, "json")};
  for (const std::string& name : names) writeText(folder / name, "damaged");
  const Checks damaged = checkCaches(device);
  REQUIRE(damaged.size() == 3);
  CHECK_THAT(damaged[0].text, Contains("files of compiled pipelines: 1, of tuning: 1"));
  for (std::size_t i = 0; i < names.size(); ++i) {
    CHECK(damaged[i + 1].status == Status::warning);
    CHECK_THAT(damaged[i + 1].text, Contains(names[i] + " is ignored: "));
    CHECK(damaged[i + 1].remedy == "delete this file");
  }
}

TEST_CASE("memory and the working folder are reported") {
  const TemporaryFolder folder;
  const Checks checks = checkResources(folder.path());
  REQUIRE(checks.size() == 2);
  CHECK_THAT(checks[0].text, Contains("GiB available"));
  CHECK_THAT(checks[1].text, Contains(folder.path().string() + " is writable"));
  writeText(folder / "file", "");
  const Checks wrong = checkResources(folder / "file");
  CHECK(wrong[1].status == Status::warning);
  CHECK_FALSE(wrong[1].remedy.empty());
}

}  // namespace candela::doctor

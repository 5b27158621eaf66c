// Driver discovery: variables, folders, and files that are wrong.
#include "host/drivers/doctor/driver_files.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/base/temporary_folder.h"
#include "tests/trace/vulkan/environment_guard.h"

namespace candela::doctor {
namespace {

using Catch::StartsWith;
using vulkan::EnvironmentGuard;

constexpr const char* kManifest = R"({"file_format_version": "1.0.0", "ICD": {"library_path": "libdriver.so"}})";

DriverManifest manifestOf(const std::string& text) {
  const TemporaryFolder folder;
  writeText(folder / "a.json", text);
  return readManifest(folder / "a.json");
}

}  // namespace

TEST_CASE("a manifest names its library, relative to its folder if it has one") {
  const TemporaryFolder folder;
  writeText(folder / "a.json", kManifest);
  CHECK(readManifest(folder / "a.json").library == "libdriver.so");
  writeText(folder / "b.json", R"({"ICD": {"library_path": "./libdriver.so"}})");
  CHECK(readManifest(folder / "b.json").library == (folder.path() / "./libdriver.so").string());
  writeText(folder / "c.json", R"({"ICD": {"library_path": "/lib/libdriver.so"}})");
  CHECK(readManifest(folder / "c.json").library == "/lib/libdriver.so");
  CHECK(readManifest(folder / "c.json").problem.empty());
}

TEST_CASE("a manifest that is wrong has a reason, and no library") {
  CHECK_THAT(manifestOf("{\"ICD\":\n {,").problem,
             StartsWith("has an error at line 2, column 3: not valid JSON: syntax"));
  CHECK_THAT(manifestOf("").problem, StartsWith("has an error at line 1, column 1: not valid JSON: "));
  CHECK(manifestOf("{\"ICD\": 1e999}").problem == "has an error at line 1, column 9: not valid JSON: number overflow");
  CHECK(manifestOf("{\"ICD\":" + std::string(300, '[')).problem ==
        "has an error at line 1, column 263: JSON is nested more than 256 levels deep");
  CHECK(manifestOf("[1]").problem == "has no object \"ICD\"");
  CHECK(manifestOf("{\"ICD\": 3}").problem == "has no object \"ICD\"");
  CHECK(manifestOf("{\"ICD\": {}}").problem == "has no string \"library_path\" in \"ICD\"");
  CHECK(manifestOf("{\"ICD\": {\"library_path\": [1]}}").problem == "has no string \"library_path\" in \"ICD\"");
  CHECK(manifestOf(std::string(2 << 20, ' ')).problem == "cannot be read: too large");
  CHECK(manifestOf(std::string("\xff\0\x1b", 3)).library.empty());
  CHECK(readManifest("/nonexistent/a.json").problem == "does not exist");
  CHECK(readManifest("/dev/null").problem == "cannot be read: not a regular file");
}

TEST_CASE("VK_DRIVER_FILES replaces VK_ICD_FILENAMES, and both replace the folders") {
  const TemporaryFolder folder;
  for (const char* name : {"a.json", "b.json", "c.txt"}) writeText(folder / name, kManifest);
  const EnvironmentGuard old("VK_ICD_FILENAMES", (folder / "a.json").string());
  const EnvironmentGuard none("VK_DRIVER_FILES", "");
  CHECK(findDriverFiles().variable == "VK_ICD_FILENAMES");
  CHECK(findDriverFiles().manifests.size() == 1);
  const EnvironmentGuard files("VK_DRIVER_FILES", folder.path().string() + ":/nonexistent.json");
  const DriverFiles found = findDriverFiles();
  CHECK(found.variable == "VK_DRIVER_FILES");
  REQUIRE(found.manifests.size() == 3);
  CHECK(found.manifests[0].file == folder / "a.json");
  CHECK(found.manifests[1].file == folder / "b.json");
  CHECK(found.manifests[2].problem == "does not exist");
}

TEST_CASE("drivers are found in the folders of the XDG base directory specification") {
  const TemporaryFolder folder;
  for (const char* name : {"config", "configs", "data", "datas"}) {
    std::filesystem::create_directories(folder.path() / name / "vulkan" / "icd.d");
    writeText(folder.path() / name / "vulkan" / "icd.d" / (std::string(name) + ".json"), kManifest);
  }
  writeText(folder / "added.json", kManifest);
  const EnvironmentGuard old("VK_ICD_FILENAMES", "");
  const EnvironmentGuard files("VK_DRIVER_FILES", "");
  const EnvironmentGuard config("XDG_CONFIG_HOME", (folder / "config").string());
  const EnvironmentGuard configs("XDG_CONFIG_DIRS", (folder / "configs").string());
  const EnvironmentGuard data("XDG_DATA_HOME", (folder / "data").string());
  const EnvironmentGuard datas("XDG_DATA_DIRS", (folder / "datas").string() + ":/usr/share");
  const EnvironmentGuard added("VK_ADD_DRIVER_FILES", (folder / "added.json").string());
  const DriverFiles found = findDriverFiles();
  CHECK(found.variable.empty());
  std::vector<std::string> own;
  for (const DriverManifest& manifest : found.manifests) {
    if (manifest.file.string().starts_with(folder.path().string())) own.push_back(manifest.file.stem().string());
  }
  CHECK(own == std::vector<std::string>{"config", "configs", "data", "datas", "added"});
  const std::vector<std::filesystem::path> fixed{"/etc/vulkan/icd.d", "/usr/share/vulkan/icd.d"};
  for (const std::filesystem::path& path : fixed) CHECK(std::ranges::count(found.folders, path) == 1);
}

}  // namespace candela::doctor

// `candela doctor` on a device that works, alone and beside drivers that do not.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "tests/app/cli/doctor_report.h"
#include "tests/app/cli/run_program.h"

namespace candela {
namespace {

using nlohmann::json;

std::string workingDriver() {
  const char* const file = std::getenv("VK_ICD_FILENAMES");
  return file == nullptr ? "" : file;
}

ProgramResult runBeside(const std::string& manifest) {
  const std::string files = manifest + ":" + workingDriver();
  return runCandela({"doctor", "--json", "-"},
                    {.environment = {"VK_DRIVER_FILES=" + files, "VK_ICD_FILENAMES=" + files}});
}

std::string manifestOf(const std::string& library) {
  return R"({"file_format_version": "1.0.0", "ICD": {"api_version": "1.2.0", "library_path": ")" + library + "\"}}";
}

}  // namespace

TEST_CASE("doctor finds that a render works, although the cache folder is a file and a driver is missing",
          "[swiftshader-slow]") {
  const TemporaryFolder folder;
  const std::string files = folder.write("missing.json", manifestOf("/nonexistent/lib.so")) + ":" + workingDriver();
  const ProgramResult result = runCandela({"doctor", "--json", "-"},
                                          {.environment = {"VK_DRIVER_FILES=" + files, "VK_ICD_FILENAMES=" + files,
                                                           "CANDELA_CACHE_DIR=" + folder.write("cache", "")}});
  INFO(result.out << result.err);
  REQUIRE(result.exitCode == 0);
  const json report = json::parse(result.out);
  CHECK(report["agrees"] == true);
  CHECK(report["comparison"]["agrees"] == true);
  CHECK(report["devices"][0]["name"] == report["device"]);
  CHECK(checkNamed(report, "test picture")["status"] == "ok");
  CHECK(checkNamed(report, "driver missing.json")["status"] == "warning");
  CHECK(checkNamed(report, "cache folder")["status"] == "warning");
}

TEST_CASE("doctor says how to leave out a driver that crashes beside one that works", "[swiftshader-slow]") {
  if (workingDriver().empty()) return;  // by hand, with the system's drivers: their files are not known here
  const TemporaryFolder folder;
  const ProgramResult result = runBeside(folder.write("crash.json", manifestOf(CANDELA_CRASHING_DRIVER)));
  CHECK(result.exitCode == 4);
  const json report = json::parse(result.out);
  CHECK(contains(checkNamed(report, "driver crash.json")["text"], "crashes (Aborted)"));
  CHECK(checkNamed(report, "devices")["remedy"] == "export VK_ICD_FILENAMES=" + workingDriver());
}

TEST_CASE("doctor on a device that does not exist lists the others, and exits with 4", "[swiftshader-slow]") {
  const ProgramResult result = runCandela({"doctor", "--device", "no such device"});
  CHECK(result.exitCode == 4);
  CHECK(contains(result.out, "problem  chosen device: no Vulkan device \"no such device\"\n"));
}

}  // namespace candela

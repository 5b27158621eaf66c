// Drivers that crash, cannot be opened or do not exist.
#include "host/drivers/doctor/driver_check.h"

#include <catch2/catch.hpp>

#include "tests/base/temporary_folder.h"
#include "tests/trace/vulkan/environment_guard.h"

namespace candela::doctor {
namespace {

using Catch::Contains;
using vulkan::EnvironmentGuard;

// The diagnosis of a machine whose only driver has this library.
DriverDiagnosis diagnosisWith(const std::string& library, bool hasLoader = true) {
  const TemporaryFolder folder;
  writeText(folder / "made.json",
            R"({"file_format_version": "1.0.0", "ICD": {"api_version": "1.2.0", "library_path": ")" + library + "\"}}");
  const EnvironmentGuard files("VK_DRIVER_FILES", (folder / "made.json").string());
  const EnvironmentGuard old("VK_ICD_FILENAMES", (folder / "made.json").string());
  return checkDrivers(hasLoader);
}

void requireProblems(const DriverDiagnosis& diagnosis) {
  CHECK_FALSE(diagnosis.anyUsable);
  CHECK(diagnosis.devices.empty());
  REQUIRE(diagnosis.checks.size() == 2);
  for (const Check& check : diagnosis.checks) {
    CHECK(check.status == Status::problem);
    CHECK_THAT(check.remedy, Contains("apt-get install mesa-vulkan-drivers"));
  }
  CHECK(diagnosis.checks[0].name == "driver made.json");
  CHECK(diagnosis.checks[1].name == "devices");
}

}  // namespace

TEST_CASE("a driver that crashes in enumeration is named, with its last message") {
  const DriverDiagnosis diagnosis = diagnosisWith(CANDELA_CRASHING_DRIVER);
  requireProblems(diagnosis);
  CHECK_THAT(diagnosis.checks[0].text, Contains("crashes (Aborted), after \"crashing_driver: assertion failed\""));
  CHECK_THAT(diagnosis.checks[0].remedy, Contains("dpkg -S "));
  CHECK_THAT(diagnosis.checks[1].text, Contains("crashes (Aborted)"));
}

TEST_CASE("a driver whose library does not exist is named with the reason of the dynamic linker") {
  const DriverDiagnosis diagnosis = diagnosisWith("/nonexistent/libdriver.so");
  requireProblems(diagnosis);
  CHECK_THAT(diagnosis.checks[0].text, Contains("/nonexistent/libdriver.so: cannot open shared object file"));
  CHECK(diagnosis.checks[1].text == "none found");
}

TEST_CASE("a library that is not a Vulkan driver is named") {
  const DriverDiagnosis diagnosis = diagnosisWith("libm.so.6");
  requireProblems(diagnosis);
  CHECK_THAT(diagnosis.checks[0].text, Contains("libm.so.6 is not a Vulkan driver"));
}

TEST_CASE("a variable that names no driver is the problem") {
  const TemporaryFolder empty;
  const EnvironmentGuard files("VK_DRIVER_FILES", empty.path().string());
  const EnvironmentGuard old("VK_ICD_FILENAMES", (empty / "none.json").string());
  const DriverDiagnosis diagnosis = checkDrivers(true);
  REQUIRE(diagnosis.checks.size() == 2);
  CHECK(diagnosis.checks[0].text == "VK_DRIVER_FILES names no driver");
  CHECK(diagnosis.checks[0].remedy == "unset VK_DRIVER_FILES");
  CHECK_THAT(diagnosis.checks[1].remedy, Contains("unset VK_DRIVER_FILES"));
}

TEST_CASE("a variable that is set, but empty, is named if no device is found") {
  const TemporaryFolder empty;
  const EnvironmentGuard files("VK_DRIVER_FILES", "");
  const EnvironmentGuard old("VK_ICD_FILENAMES", (empty / "none.json").string());
  const DriverDiagnosis diagnosis = checkDrivers(true);
  CHECK(diagnosis.checks.back().text == "none found; VK_DRIVER_FILES is set, but names no driver");
  CHECK_THAT(diagnosis.checks.back().remedy, Contains("unset VK_DRIVER_FILES"));
}

TEST_CASE("a filter of drivers is named if no device is found") {
  const EnvironmentGuard filter("VK_LOADER_DRIVERS_DISABLE", "*");
  const DriverDiagnosis diagnosis = diagnosisWith("libm.so.6");
  CHECK(diagnosis.checks.back().text == "none found; VK_LOADER_DRIVERS_DISABLE=* may hide drivers");
  CHECK_THAT(diagnosis.checks.back().remedy, Contains("unset VK_LOADER_DRIVERS_DISABLE"));
}

TEST_CASE("without the loader, nothing is said about devices of drivers, and the loader is the remedy") {
  const DriverDiagnosis diagnosis = diagnosisWith("libm.so.6", false);
  REQUIRE(diagnosis.checks.size() == 2);
  CHECK(diagnosis.checks[0].status == Status::ok);
  CHECK(diagnosis.checks[0].text == "registered; it cannot be examined without the Vulkan loader");
  CHECK(diagnosis.checks[1].status == Status::problem);
  CHECK(diagnosis.checks[1].remedy == "apt-get install libvulkan1");
}

}  // namespace candela::doctor

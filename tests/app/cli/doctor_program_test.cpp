// `candela doctor` on machines without a driver that works.
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/app/cli/doctor_report.h"
#include "tests/app/cli/run_program.h"

namespace candela {
namespace {

using nlohmann::json;

// Returns the report with `manifest` as the only driver; it must state that no render works.
json reportWith(const std::string& manifest, const std::vector<std::string>& words = {}) {
  std::vector<std::string> all{"doctor", "--json", "-"};
  all.insert(all.end(), words.begin(), words.end());
  const ProgramResult result = runCandela(
      all, {.environment = {"VK_DRIVER_FILES=" + manifest, "VK_ICD_FILENAMES=" + manifest}});
  INFO(result.out << result.err);
  REQUIRE(result.exitCode == 4);
  json report = json::parse(result.out);
  CHECK(report["agrees"].is_null());
  CHECK(report["exitCode"] == 4);
  CHECK(report["device"].is_null());
  for (const json& check : report["checks"]) {
    CHECK(check["remedy"].get<std::string>().empty() == (check["status"] == "ok"));
  }
  return report;
}

}  // namespace

TEST_CASE("doctor without any driver says what to do, and exits with 4") {
  const json check = checkNamed(reportWith("/nonexistent/none.json"), "driver none.json");
  CHECK(check["status"] == "problem");
  CHECK(contains(check["text"], "/nonexistent/none.json does not exist"));
  CHECK(contains(check["remedy"], "unset VK_DRIVER_FILES"));
}

TEST_CASE("doctor names a driver file that is not JSON, and one whose library does not exist") {
  const TemporaryFolder folder;
  const json broken = checkNamed(reportWith(folder.write("broken.json", "{\"ICD\"")), "driver broken.json");
  CHECK(contains(broken["text"], "has an error at line 1, column"));
  const std::string absent = R"({"file_format_version": "1.0.0", "ICD": {"library_path": "/nonexistent/lib.so"}})";
  const json missing = checkNamed(reportWith(folder.write("missing.json", absent)), "driver missing.json");
  CHECK(contains(missing["text"], "/nonexistent/lib.so: cannot open shared object file"));
}

TEST_CASE("doctor survives a driver that crashes") {
  const TemporaryFolder folder;
  const std::string manifest = folder.write(
      "crash.json",
      R"({"file_format_version": "1.0.0", "ICD": {"api_version": "1.2.0", "library_path": ")" CANDELA_CRASHING_DRIVER
      R"("}})");
  const json check = checkNamed(reportWith(manifest), "driver crash.json");
  CHECK(contains(check["text"], "crashes (Aborted)"));
}

TEST_CASE("doctor prints one line for each check and how to fix each problem") {
  const ProgramResult result = runCandela({"doctor"}, {.environment = {"VK_DRIVER_FILES=/nonexistent/none.json",
                                                                       "VK_ICD_FILENAMES=/nonexistent/none.json"}});
  CHECK(result.exitCode == 4);
  CHECK(contains(result.out, "problem  driver none.json: /nonexistent/none.json does not exist\n"));
  CHECK(contains(result.out, "         how to fix: unset VK_DRIVER_FILES"));
  CHECK(contains(result.out, "A render will not work"));
}

TEST_CASE("doctor works in a folder that was removed") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path("gone"));
  const ProgramResult result = runProgram(
      "/bin/sh", {"-c", "cd \"$0\" && rmdir \"$0\" && exec \"$1\" doctor", folder.path("gone"), CANDELA_PROGRAM},
      {.environment = {"VK_DRIVER_FILES=/nonexistent/none.json"}});
  CHECK(result.exitCode == 4);
  CHECK(contains(result.out, "warning  working folder: it was removed, so that"));
}

TEST_CASE("doctor refuses what it cannot do before it does anything") {
  CHECK(runCandela({"doctor", "--device", "cpu"}).exitCode == 1);
  CHECK(runCandela({"doctor", "a.p3f"}).exitCode == 1);
  CHECK(runCandela({"doctor", "--json", "/nonexistent/a.json"}).exitCode == 2);
}

}  // namespace candela

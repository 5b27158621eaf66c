// The cases on a driver: the leaf functions in the default tests, and the complete run among the slow ones.
#include <catch2/catch.hpp>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/app/cli/run_program.h"
#include "tests/trace/vulkan_support/test_device.h"

namespace candela {
namespace {

using nlohmann::json;

constexpr const char* kBaselines = CANDELA_SOURCE_DIR "/host/drivers/conformance/baselines/";

std::string driverOf() { return openTestDevice().info().driver; }

// The baseline of the driver, if it has one.
std::vector<std::string> baselineOptions(const std::string& driver) {
  if (driver.find("Mesa 22.3.6") != std::string::npos)
    return {"--baseline", std::string(kBaselines) + "lavapipe-22.3.6-fails.txt"};
  if (driver.find("SwiftShader") == std::string::npos) return {};
  return {"--baseline", std::string(kBaselines) + "swiftshader-fails.txt", "--skips",
          std::string(kBaselines) + "swiftshader-skips.txt"};
}

ProgramResult runCases(const std::string& glob, std::vector<std::string> more) {
  std::vector<std::string> words{"conformance", "--cases", glob, "--json", "-", "--timeout", "240s"};
  words.insert(words.end(), more.begin(), more.end());
  return runCandela(words);
}

}  // namespace

TEST_CASE("conformance: leaf functions pass") {
  const ProgramResult result = runCases("leaf.*", {});
  INFO(result.out);
  REQUIRE(result.exitCode == 0);
  const json report = json::parse(result.out);
  CHECK(report["cases"].size() > 30);
  CHECK(report["counts"]["Pass"] == report["cases"].size());
}

TEST_CASE("conformance: the results of control flow and memory are those of the driver's baseline") {
  for (const char* const glob : {"control.*", "memory.*", "group.*"}) {
    const ProgramResult result = runCases(glob, baselineOptions(driverOf()));
    INFO(result.out);
    CHECK(result.exitCode == 0);
  }
}

TEST_CASE("conformance: without a baseline the faults of lavapipe 22.3.6 are found, with the values that differ") {
  if (driverOf().find("Mesa 22.3.6") == std::string::npos) return;
  const ProgramResult result = runCases("control.loop.*", {});
  REQUIRE(result.exitCode == 3);
  std::map<std::string, json> cases;
  const json report = json::parse(result.out);
  for (const json& one : report["cases"]) cases[one["name"]] = one;
  CHECK(cases["control.loop.iterations"]["result"] == "Fail");
  CHECK(contains(cases["control.loop.iterations"]["text"], "expected 1048576 (0x100000), found 65535 (0xffff)"));
  CHECK(cases["control.loop.ended_in_the_middle"]["result"] == "Fail");
  CHECK(contains(cases["control.loop.ended_in_the_middle"]["text"], "value 2: expected 15 (0xf), found 17 (0x11)"));
  CHECK(cases["control.loop.ended_at_the_end"]["result"] == "Pass");
}

// On lavapipe 22.3.6, some of these cases fail if they run.
TEST_CASE("conformance --compile-only creates all pipelines and runs nothing") {
  for (const char* const glob : {"leaf.*", "control.*", "memory.*", "group.*", "kernel.*"}) {
    const ProgramResult result = runCases(glob, {"--compile-only"});
    INFO(result.out);
    REQUIRE(result.exitCode == 0);
    const json report = json::parse(result.out);
    CHECK(report["compileOnly"] == true);
    for (const json& one : report["cases"]) {
      // One has no shader; SwiftShader lacks subgroups of other sizes, and workgroups of more than 256 invocations.
      const bool maySkip = one["name"] == "memory.command.copy" || one["name"] == "group.size.256x2x1" ||
                           contains(one["name"], "subgroup");
      CAPTURE(one["name"]);
      CHECK((one["result"] == "Pass" || (maySkip && one["result"] == "Skip")));
    }
  }
  CHECK(runCases("variants.module.*.control.stack.*", {"--compile-only", "--variants"}).exitCode == 0);
}

TEST_CASE("conformance: the results of the complete run are those of the driver's baseline", "[slow]") {
  const ProgramResult result = runCases("*", baselineOptions(driverOf()));
  INFO(result.out);
  CHECK(result.exitCode == 0);
}

}  // namespace candela

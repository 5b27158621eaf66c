// `candela explain` and `verify --explain` as a user runs them, on a Vulkan device.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "tests/app/cli/run_program.h"

namespace candela {
namespace {

using Catch::Contains;
using nlohmann::json;

ProgramResult explainOnDevice(std::vector<std::string> words) {
  if (const char* device = std::getenv("CANDELA_TEST_DEVICE")) words.insert(words.end(), {"--device", device});
  return runCandela(words);
}

}  // namespace

TEST_CASE("explain prints two equal paths as text and as JSON") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string file = folder.path("a.json");
  const ProgramResult result = explainOnDevice(
      {"explain", scene, "--pixel", "8,6", "--sample", "3", "--seed", "2", "--json", file});
  INFO(result.out << result.err);
  REQUIRE(result.exitCode == 0);
  CHECK_THAT(result.out, Contains("a.p3f, pixel 8,6, sample 3, seed 2: ") && Contains("The two paths agree: ") &&
                             Contains("\ncamera\n") && Contains("\nvertex 1\n") && Contains("\nsample\n"));
  const json report = json::parse(readText(file));
  CHECK(report["agrees"] == true);
  CHECK(report["sample"] == 3);
  CHECK(report["stages"].size() == 2 + report["vertexCount"]["device"].get<std::size_t>());
}

TEST_CASE("explain without --pixel explains the pixel that differs most, or reports that none differs",
          "[swiftshader-slow]") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const ProgramResult few = explainOnDevice({"explain", scene, "--size", "8x8", "--json", "-"});
  INFO(few.out << few.err);
  REQUIRE(few.exitCode == 0);
  CHECK(json::parse(few.out)["agrees"] == true);
  CHECK_THAT(explainOnDevice({"explain", scene, "--size", "8x8"}).out,
             Contains("Nothing to explain: at one sample all 64 pixels are equal."));
}

TEST_CASE("verify --explain reports that there is nothing to explain if all pixels are equal", "[swiftshader-slow]") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const ProgramResult result = explainOnDevice({"verify", scene, "--size", "8x8", "--bias", "20%", "--explain"});
  INFO(result.out << result.err);
  CHECK(result.exitCode == 0);
  CHECK_THAT(result.out, Contains("compute the same light") && Contains("Nothing to explain"));
}

}  // namespace candela

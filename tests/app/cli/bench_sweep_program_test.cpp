// `candela bench SCENE --sweep` and `bench compare` as a user runs them, on the reference tracer.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/app/cli/run_program.h"

namespace candela {
namespace {

using Catch::Contains;
using nlohmann::json;

// Runs `bench SCENE` with more words.
ProgramResult benchScene(const TemporaryFolder& folder, const std::vector<std::string>& words) {
  std::vector<std::string> all{
      "bench", folder.write("a.p3f", smallScene()), "--device", "cpu", "--repeat", "1", "--spp", "1"};
  all.insert(all.end(), words.begin(), words.end());
  return runCandela(all);
}

TEST_CASE("bench SCENE renders every combination of the options that are swept") {
  const TemporaryFolder folder;
  const ProgramResult result = benchScene(
      folder, {"--sweep", "accel=none,grid", "--sweep", "threads=1,2", "--json", "-", "--svg", folder.path("a.svg")});
  INFO(result.err);
  REQUIRE(result.exitCode == 0);
  const json report = json::parse(result.out);
  std::vector<std::string> names;
  for (const json& row : report["rows"]) names.push_back(row["variant"]);
  CHECK(names == std::vector<std::string>{"accel=none threads=1", "accel=none threads=2", "accel=grid threads=1",
                                          "accel=grid threads=2"});
  CHECK(report["rows"][0]["structure"] == "none");
  CHECK(report["rows"][2]["structure"] == "grid");
  CHECK(report["rows"][0]["filmHash"] == report["rows"][3]["filmHash"]);
  CHECK(report["processBytes"] > 1'000'000);
  CHECK_THAT(readText(folder.path("a.svg")), Contains("accel=grid threads=2"));
}

TEST_CASE("options that determine the image can be swept, and only variants with equal images are compared") {
  const TemporaryFolder folder;
  const ProgramResult result = benchScene(folder,
                                          {"--sweep", "nee=on,off", "--sweep", "accel=none,bvh", "--json", "-"});
  INFO(result.err);
  REQUIRE(result.exitCode == 0);
  const json rows = json::parse(result.out)["rows"];
  REQUIRE(rows.size() == 4);
  CHECK(rows[0]["filmHash"] == rows[1]["filmHash"]);
  CHECK(rows[0]["filmHash"] != rows[2]["filmHash"]);
  CHECK(rows[0]["relMse"] == rows[1]["relMse"]);
  CHECK(rows[0]["relMse"] != rows[2]["relMse"]);
  CHECK(rows[0]["relMse"] > 0);
}

TEST_CASE("bench SCENE without a sweep measures the given options") {
  const TemporaryFolder folder;
  const ProgramResult result = benchScene(folder, {});
  REQUIRE(result.exitCode == 0);
  CHECK_THAT(result.out, Contains("as given") && Contains("Msamples/s") && Contains("a.p3f 16x12 x 1 spp"));
}

TEST_CASE("an invalid sweep is refused with the reason") {
  const TemporaryFolder folder;
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{"--sweep", "workgroup"}, "expected an option and its values"},
      {{"--sweep", "wrkgroup=8x8"}, "did you mean workgroup?"},
      {{"--sweep", "workgroup=8x8,"}, "got \"\""},
      {{"--sweep", "workgroup=8"}, "--sweep workgroup: expected XxY"},
      {{"--sweep", "device=cpu,0"}, "not an option that can be swept"},
      {{"--sweep", "one-sided=on"}, "not an option that can be swept"},
      {{"--sweep", "threads=1", "--sweep", "threads=2"}, "swept twice"}};
  for (const auto& [words, message] : cases) {
    const ProgramResult result = benchScene(folder, words);
    CHECK(result.exitCode == 1);
    CHECK_THAT(result.err, Contains(message));
  }
  std::vector<std::string> many{"--sweep", "threads=1", "--sweep", "seed=0"};
  for (int i = 2; i <= 20; ++i) many[1] += "," + std::to_string(i), many[3] += "," + std::to_string(i);
  CHECK_THAT(benchScene(folder, many).err, Contains("more than 256 combinations"));
}

TEST_CASE("bench compare exits with 3 if a row became slower, and with 0 for equal reports") {
  const TemporaryFolder folder;
  const std::string old = folder.path("old.json");
  REQUIRE(benchScene(folder, {"--sweep", "threads=1,2", "--json", old}).exitCode == 0);
  CHECK(runCandela({"bench", "compare", old, old}).exitCode == 0);
  json report = json::parse(readText(old));
  report["rows"][1]["mraysPerSecond"] = report["rows"][1]["mraysPerSecond"].get<double>() * 0.9;
  const std::string slower = folder.write("new.json", report.dump());
  const ProgramResult result = runCandela({"bench", "compare", old, slower, "--threshold", "5%"});
  CHECK(result.exitCode == 3);
  CHECK_THAT(result.out, Contains("-10.0 %") && Contains("slower"));
  CHECK(runCandela({"bench", "compare", old, slower, "--threshold", "20%"}).exitCode == 0);
}

TEST_CASE("bench compare refuses a file that is no report, and names it") {
  const TemporaryFolder folder;
  const std::string text = folder.write("a.json", "not JSON");
  CHECK(runCandela({"bench", "compare", text, text}).exitCode == 2);
  CHECK_THAT(runCandela({"bench", "compare", text, text}).err, Contains("a.json"));
  CHECK(runCandela({"bench", "compare", folder.path("absent.json"), text}).exitCode == 2);
  CHECK(runCandela({"bench", "compare", text}).exitCode == 1);
  CHECK_THAT(runCandela({"bench", "compare", text, text, text}).err, Contains("expected two reports"));
}

TEST_CASE("options of bench SCENE are refused by the other benchmarks") {
  for (const std::string option : {"--sweep", "--svg"}) {
    const ProgramResult result = runCandela({"bench", "table1", option, "x"});
    CHECK(result.exitCode == 1);
    CHECK_THAT(result.err, Contains("this option applies only to bench SCENE"));
  }
}

}  // namespace
}  // namespace candela

// `candela bench SCENE --sweep` and `bench compare` as a user runs them, on the reference tracer.
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/app/cli/run_program.h"

namespace candela {
namespace {

using Catch::Contains;
using nlohmann::json;

// Runs `bench SCENE` with more words.
ProgramResult benchScene(const TemporaryFolder& folder, const std::vector<std::string>& words,
                         const std::string& repeats = "1") {
  std::vector<std::string> all{
      "bench", folder.write("a.p3f", smallScene()), "--device", "cpu", "--repeat", repeats, "--spp", "1"};
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

TEST_CASE("bench SCENE --error measures the error in equal time of each image") {
  const TemporaryFolder folder;
  const ProgramResult result = benchScene(
      folder, {"--error", "3", "--sweep", "nee=on,off", "--json", folder.path("a.json"), "--markdown", "-"}, "2");
  INFO(result.err);
  REQUIRE(result.exitCode == 0);
  CHECK_THAT(result.out, Contains("| error after 1 s |"));
  CHECK_THAT(result.err, Contains("a.p3f: error of 3 pictures, and a reference of 24 times their samples"));
  const json rows = json::parse(readText(folder.path("a.json")))["rows"];
  REQUIRE(rows.size() == 2);
  for (const json& row : rows) {
    const double root = std::sqrt(row["relMse"].get<double>() * row["medianSeconds"].get<double>());
    CHECK(row["errorAfterSecond"] == Approx(root));
    CHECK(row["errorAfterSecondLow"] < root);
    CHECK(row["errorAfterSecondHigh"] > root);
  }
  CHECK(rows[0]["relMse"] < rows[1]["relMse"]);  // the light is small
}

TEST_CASE("an error needs two pictures and two runs") {
  const TemporaryFolder folder;
  CHECK_THAT(benchScene(folder, {"--error", "1"}).err, Contains("--error 1: an error needs at least 2 pictures"));
  CHECK_THAT(benchScene(folder, {"--error", "2"}).err, Contains("use --repeat 2 or more"));
  CHECK(benchScene(folder, {"--error", "2"}).exitCode == 1);
}

TEST_CASE("bench error compares renderers by their pictures and times") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  json tracer{{"tracer", "A"}, {"samplesPerPixel", 1}};
  for (int seed = 0; seed < 4; ++seed) {
    const std::string name = std::to_string(seed) + ".exr";
    const std::string spp = seed < 2 ? "1" : "8";
    REQUIRE(runCandela(
                {scene, "--device", "cpu", "--spp", spp, "--seed", std::to_string(seed), "-o", folder.path(name), "-q"})
                .exitCode == 0);
    if (seed < 2) tracer["pictures"].push_back({{"file", name}, {"seconds", 1}});
    if (seed >= 2) tracer["reference"].push_back(name);
  }
  json slow = tracer;
  slow["tracer"] = "B";
  for (json& picture : slow["pictures"]) picture["seconds"] = 4;
  const json document{{"schema", "candela-error-runs/1"}, {"scene", "a.p3f"}, {"tracers", {tracer, slow}}};
  const ProgramResult result = runCandela(
      {"bench", "error", folder.write("runs.json", document.dump()), "--json", "-"});
  INFO(result.err);
  REQUIRE(result.exitCode == 0);
  CHECK(json::parse(result.out)["rows"][1]["errorRatio"] == Approx(2));
  CHECK(runCandela({"bench", "error"}).exitCode == 1);
  CHECK(runCandela({"bench", "error", folder.write("no.json", "{}")}).exitCode == 2);
  CHECK_THAT(runCandela({"bench", "error", "a.json", "--error", "3"}).err, Contains("applies only to bench SCENE"));
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

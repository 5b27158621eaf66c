// `candela bench` as a user runs it, on the reference tracer.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/app/cli/run_program.h"

namespace candela {
namespace {

using Catch::Contains;
using nlohmann::json;

const std::vector<std::string> kQuick{"--device", "cpu", "--size", "16x12", "--spp", "1", "--repeat", "2"};

ProgramResult runBench(const std::vector<std::string>& words) {
  std::vector<std::string> all{"bench"};
  all.insert(all.end(), words.begin(), words.end());
  all.insert(all.end(), kQuick.begin(), kQuick.end());
  return runCandela(all);
}

}  // namespace

TEST_CASE("bench table1 measures three structures on two built-in scenes, without files") {
  const TemporaryFolder folder;
  const std::string markdown = folder.path("table.md");
  const ProgramResult result = runBench({"table1", "--json", "-", "--markdown", markdown});
  INFO(result.err);
  REQUIRE(result.exitCode == 0);
  const json report = json::parse(result.out);
  CHECK(report["schema"] == "candela-bench/2");
  CHECK(report["repeats"] == 2);
  REQUIRE(report["rows"].size() == 6);
  CHECK(report["rows"][0]["scene"] == "mirror");
  CHECK(report["rows"][3]["scene"] == "balls");
  for (const json& row : report["rows"]) {
    CHECK(row["agrees"] == true);
    CHECK(row["medianSeconds"] > 0);
    CHECK_FALSE(row.contains("publishedSeconds"));  // the published seconds are for other work
  }
  CHECK(report["rows"][0]["filmHash"] != report["rows"][3]["filmHash"]);
  CHECK_THAT(readText(markdown), Contains("| mirror | uniform grid |") && !Contains("published"));
}

TEST_CASE("bench accel compares structures on any scenes") {
  const TemporaryFolder folder;
  const ProgramResult result = runBench({"accel", folder.write("a.p3f", smallScene())});
  INFO(result.err);
  REQUIRE(result.exitCode == 0);
  CHECK_THAT(result.out, Contains("a.p3f") && Contains("uniform grid") && Contains("Mrays/s"));
  CHECK_THAT(result.out, !Contains("published"));
}

TEST_CASE("a benchmark that does not exist, or lacks its scene, is a usage error") {
  CHECK_THAT(runBench({"tabel1"}).err, Contains("did you mean table1?"));
  CHECK(runBench({"tabel1"}).exitCode == 1);
  CHECK(runBench({std::string(300, 'a')}).exitCode == 1);  // no file system has such a name
  CHECK(runBench({"accel"}).exitCode == 1);
  CHECK_THAT(runBench({"rays"}).err, Contains("bench rays: no scene given"));
  CHECK_THAT(runBench({"rays", "absent.p3f"}).err, Contains("the rays of the reference tracer cannot be timed alone"));
  CHECK(runBench({"table1", "a.p3f"}).exitCode == 1);
  CHECK(runBench({"accel", "absent.p3f"}).exitCode == 2);
  CHECK(runBench({"table1", "--integrator", "cost"}).exitCode == 1);
  CHECK(runBench({"table1", "--json", "-", "--markdown", "-"}).exitCode == 1);
}

}  // namespace candela

// Reading results of the kit, and the reports on them.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "host/base/errors.h"
#include "host/measure/kit/kit_report.h"
#include "tests/app/cli/run_program.h"

namespace candela::kit {
namespace {

using Catch::Contains;
using nlohmann::json;

json madeCase(const char* name, const char* result) { return {{"name", name}, {"result", result}}; }

json madeRow(const char* scene, const char* variant, double speed) {
  return {{"scene", scene},
          {"variant", variant},
          {"msamplesPerSecond", speed},
          {"mraysPerSecond", 5 * speed},
          {"spread", 0.02}};
}

json madeRays(const char* kind, const char* layout, double speed) {
  return {
      {"scene", "room.p3f"}, {"rayKind", kind}, {"layout", layout}, {"sceneLoads", "texel"}, {"mraysPerSecond", speed}};
}

json report(const std::string& device) { return {{"device", device}, {"driver", device + " driver 1"}}; }

// The results of one device, on which the second variant is the faster one.
json madeResults(const std::string& device, double speed) {
  json conformance = report(device);
  conformance["counts"] = {{"Pass", 2}, {"Fail", 1}};
  conformance["cases"] = {madeCase("leaf.a", "Pass"), madeCase("leaf.b", "Skip"), madeCase("control.c", "Fail")};
  json verify = report(device);
  verify.update(
      {{"scene", "cornell.p3f"}, {"agrees", true}, {"verdict", "Device and reference compute the same light."}});
  json bench = report(device);
  bench["rows"] = {madeRow("cornell.p3f", "kernel=wavefront", speed / 2),
                   madeRow("cornell.p3f", "kernel=megakernel", speed)};
  json rays = report(device);
  rays["rows"] = {madeRays("primary", "bvh2", 10), madeRays("primary", "cwbvh", 20), madeRays("shadow", "cwbvh", 30)};
  return {{"schema", "candela-kit/2"},
          {"version", "0.2.0"},
          {"system", "Linux"},
          {"processor", "A processor"},
          {"quick", false},
          {"steps",
           {{{"name", "tune"}, {"exitCode", 5}, {"seconds", 7}},
            {{"name", "rays-room"}, {"exitCode", 124}, {"seconds", 60}},
            {{"name", "conformance"}, {"exitCode", 3}, {"seconds", 9}}}},
          {"conformance", conformance},
          {"verify", {verify, nullptr}},
          {"bench", {nullptr, bench}},
          {"rays", {rays}},
          {"tune", nullptr}};
}

// Reads results from a file in a temporary folder.
KitResults read(const json& results) {
  const TemporaryFolder folder;
  return readKitResults(folder.write("results.json", results.dump()));
}

}  // namespace

TEST_CASE("results of the kit are read, and the fastest variants are chosen") {
  const KitResults results = read(madeResults("A GPU", 12));
  CHECK(results.device == "A GPU");
  CHECK(results.driver == "A GPU driver 1");
  CHECK(results.caseCounts.at("Pass") == 2);
  REQUIRE(results.failedCases.size() == 1);
  CHECK(results.failedCases[0].name == "control.c");
  REQUIRE(results.verdicts.size() == 1);
  CHECK(results.verdicts[0].agree);
  const auto renders = fastestRenders(results);
  REQUIRE(renders.size() == 1);
  CHECK(renders[0].variant == "kernel=megakernel");
  const auto rays = fastestRays(results);
  REQUIRE(rays.size() == 2);
  CHECK(rays[0].mraysPerSecond == 20);
  CHECK(rays[1].kind == "shadow");
}

TEST_CASE("a step without a result is null, and the device is that of any other step") {
  json results = madeResults("A GPU", 12);
  results["conformance"] = nullptr;
  results["verify"] = {nullptr, nullptr};
  results["bench"] = json::array();
  const KitResults read = kit::read(results);
  CHECK(read.device == "A GPU");
  CHECK(read.caseCounts.empty());
  CHECK_THAT(toMarkdown({read}), Contains("Conformance: not run."));
}

TEST_CASE("the report compares devices in one table, and names failures") {
  const std::vector<KitResults> both{read(madeResults("A GPU", 12)), read(madeResults("B | GPU", 3))};
  const std::string page = toMarkdown(both);
  CHECK_THAT(page, Contains("| A GPU | A GPU driver 1 | 1 Fail, 2 Pass | 1 of 1 | 12 |"));
  CHECK_THAT(page, Contains("| B \\| GPU |"));
  CHECK_THAT(page, Contains("| A GPU driver 1 | `control.c` | Fail |"));
  CHECK_THAT(page, Contains("The step `tune` ended with exit code 5 after 7 s."));
  CHECK_THAT(page, Contains("The step `rays-room` was not finished after 60 s, its time limit."));
  CHECK_THAT(page, !Contains("The step `conformance`"));
  CHECK_THAT(page, Contains("- `cornell.p3f`: Device and reference compute the same light."));
  CHECK_THAT(toText(both), Contains("cornell.p3f (Msamples/s)"));
  const std::string chart = toSvg(both);
  CHECK_THAT(chart, Contains(">A GPU</text>"));
  CHECK_THAT(chart, Contains("3 Msamples/s"));
}

TEST_CASE("a damaged results file is refused with the place of its fault") {
  struct Fault {
    json::json_pointer pointer;
    json value;
    const char* message;
  };
  for (const Fault& fault : std::vector<Fault>{
           {json::json_pointer("/schema"), "candela-bench/1", "/schema: expected \"candela-kit/2\""},
           {json::json_pointer("/quick"), 1, "/quick: expected true or false"},
           {json::json_pointer("/bench/1/rows/0/msamplesPerSecond"), "fast",
            "/bench/1/rows/0/msamplesPerSecond: expected a number"},
           {json::json_pointer("/verify/0"), json::array(), "/verify/0: expected an object"},
           {json::json_pointer("/conformance/cases"), 3, "/conformance/cases: expected an array"},
           {json::json_pointer("/steps/0/name"), nullptr, "/steps/0/name: expected a string"},
           {json::json_pointer("/steps/0/exitCode"), 1e300, "/steps/0/exitCode: expected a whole number from 0 to 255"},
           {json::json_pointer("/conformance/counts/Pass"), -1,
            "/conformance/counts/Pass: expected a whole number from 0 to 4294967295"}}) {
    json results = madeResults("A GPU", 12);
    results[fault.pointer] = fault.value;
    INFO(fault.message);
    CHECK_THROWS_WITH(read(results), Contains(fault.message) && Contains("results.json"));
  }
}

TEST_CASE("results of earlier versions are read under their names") {
  json results = madeResults("A GPU", 12);
  results["schema"] = "candela-kit/1";
  for (json& report : results["rays"]) {
    if (report.is_null()) continue;
    for (json& row : report["rows"]) {
      row["rays"] = row["rayKind"];
      row.erase("rayKind");
    }
  }
  for (json& report : results["verify"]) {
    if (report.is_null()) continue;
    report["agree"] = report["agrees"];
    report.erase("agrees");
  }
  const KitResults today = read(madeResults("A GPU", 12)), earlier = read(results);
  REQUIRE_FALSE(today.rays.empty());
  CHECK(earlier.rays.at(0).kind == today.rays.at(0).kind);
  CHECK(earlier.verdicts.at(0).agree);
}

TEST_CASE("results without any report are refused") {
  json results = madeResults("A GPU", 12);
  for (const char* const step : {"conformance", "verify", "bench", "rays"}) results[step] = nullptr;
  CHECK_THROWS_WITH(read(results), Contains("no step of the kit gave a result"));
}

}  // namespace candela::kit

// Compares two reports of kernels: the criterion for a kernel that became worse, and broken reports.
#include "host/drivers/kernels/kernel_comparison.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "host/base/errors.h"

namespace candela::kernels {
namespace {

using Catch::Contains;
using nlohmann::json;

json row(const char* kernel, const json& figures = json::object()) {
  json line{{"scene", "a.p3f"}, {"sceneHash", "1"},   {"kernel", kernel},      {"workgroup", "8x8"},
            {"registers", 64},  {"spirvBytes", 1000}, {"compileSeconds", 0.1}, {"cycles", nullptr}};
  line.update(figures);
  return line;
}

json reportOf(std::vector<json> rows, const char* driverName = "radv") {
  return {{"schema", "candela-kernels/1"},
          {"device", "d"},
          {"driver", "v"},
          {"driverName", driverName},
          {"rows", std::move(rows)}};
}

KernelComparison compare(const json& before, const json& after, double threshold = 0.05) {
  return compareReports(before, "old.json", after, "new.json", threshold);
}

// The verdict on one figure with these values.
FigureVerdict verdictOn(const char* figure, const json& before, const json& after, double threshold = 0.05) {
  const KernelComparison comparison = compare(reportOf({row("x", {{figure, before}})}),
                                              reportOf({row("x", {{figure, after}})}), threshold);
  return comparison.rows.at(0).changes.at(0).verdict;
}

TEST_CASE("a lower occupancy, and a higher number of spills, instructions or cycles is worse") {
  CHECK(verdictOn("occupancyFraction", 0.5, 0.375) == FigureVerdict::worse);
  CHECK(verdictOn("occupancyFraction", 0.375, 0.5) == FigureVerdict::better);
  for (const char* figure : {"spillsToMemory", "spillsToRegisters", "instructions", "cycles"}) {
    CAPTURE(figure);
    CHECK(verdictOn(figure, 100, 106) == FigureVerdict::worse);
    CHECK(verdictOn(figure, 106, 100) == FigureVerdict::better);
    CHECK(verdictOn(figure, 100, 105) == FigureVerdict::changed);
    CHECK(verdictOn(figure, 105, 100) == FigureVerdict::changed);
  }
}

TEST_CASE("any spill is worse than none, and a threshold of 0 tolerates nothing") {
  CHECK(verdictOn("spillsToMemory", 0, 1, 1) == FigureVerdict::worse);
  CHECK(verdictOn("instructions", 1000, 1001, 0) == FigureVerdict::worse);
}

TEST_CASE("registers, sizes and times are listed and not judged") {
  for (const char* figure : {"registers", "codeBytes", "spirvBytes", "cacheBytes", "compileSeconds"}) {
    CAPTURE(figure);
    CHECK(verdictOn(figure, 1, 100) == FigureVerdict::changed);
  }
  CHECK(compare(reportOf({row("x", {{"compileSeconds", 1.0}})}), reportOf({row("x", {{"compileSeconds", 1.01}})}))
            .rows.at(0)
            .changes.empty());
}

TEST_CASE("a report regresses if and only if a figure is worse or missing, or a row is missing") {
  const json before = reportOf({row("x", {{"cycles", 10}}), row("y")});
  CHECK_FALSE(compare(before, before).regressed());
  CHECK_FALSE(compare(before, reportOf({row("z"), row("y"), row("x", {{"cycles", 9}})})).regressed());
  CHECK(compare(before, reportOf({row("x", {{"cycles", 11}}), row("y")})).regressed());
  CHECK(compare(before, reportOf({row("x"), row("y")})).regressed());
  CHECK(compare(before, reportOf({row("y")})).regressed());
  CHECK_FALSE(compare(reportOf({row("x"), row("y")}), before).regressed());
}

TEST_CASE("another scene under the same name is reported, but is not a regression") {
  const KernelComparison comparison = compare(reportOf({row("x", {{"cycles", 1}})}),
                                              reportOf({row("x", {{"cycles", 9}, {"sceneHash", "2"}})}));
  CHECK_FALSE(comparison.regressed());
  CHECK_THAT(toText(comparison), Contains("another scene"));
}

TEST_CASE("of different drivers, only figures in one unit are compared") {
  const json before = reportOf({row("x", {{"cycles", 10}, {"occupancyFraction", 0.5}})});
  const KernelComparison comparison = compare(
      before, reportOf({row("x", {{"cycles", 20}, {"occupancyFraction", 0.25}})}, "NVK"));
  REQUIRE(comparison.rows.at(0).changes.size() == 1);
  CHECK(comparison.rows[0].changes[0].figure->member == &Figures::occupancy);
  CHECK(comparison.regressed());
  CHECK_THAT(toText(comparison), Contains("different units"));
  CHECK(toJson(comparison)["agrees"] == false);
}

TEST_CASE("a file that is no report of kernels is refused with its name and the position") {
  const json good = reportOf({row("x")});
  const auto messageOf = [&](const json& report) {
    try {
      compare(good, report);
    } catch (const FileError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK_THAT(messageOf(json::array()), Contains("new.json: not a report of candela kernels"));
  json other = good;
  other["schema"] = "candela-bench/2";
  CHECK_THAT(messageOf(other), Contains("/schema: it has another schema"));
  for (const char* member : {"device", "driver", "driverName", "rows"}) {
    json lacking = good;
    lacking.erase(member);
    CHECK_THAT(messageOf(lacking), Contains(member));
  }
  for (const char* member : {"scene", "sceneHash", "kernel", "workgroup"}) {
    json lacking = good;
    lacking["rows"][0].erase(member);
    CHECK_THAT(messageOf(lacking), Contains("/rows/0") && Contains(member));
  }
  json wrong = good;
  wrong["rows"][0]["cycles"] = "many";
  CHECK_THAT(messageOf(wrong), Contains("/rows/0/cycles"));
}

}  // namespace
}  // namespace candela::kernels

// Compares two reports of a benchmark: the criterion for a slowdown.
#include "host/measure/bench/report_comparison.h"

#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

#include "host/base/errors.h"
#include "host/measure/bench/report_file.h"
#include "tests/base/temporary_folder.h"

namespace candela::bench {
namespace {

using Catch::Contains;
using nlohmann::json;

json row(const char* variant, double score) {
  return {{"scene", "a.p3f"},         {"sceneHash", "1"},        {"variant", variant},
          {"segmentsPerDispatch", 8}, {"mraysPerSecond", score}, {"spread", 0.01}};
}

json reportOf(std::vector<json> rows) {
  return {{"schema", "candela-bench/2"}, {"device", "d"}, {"driver", "v"}, {"rows", std::move(rows)}};
}

ReportComparison compare(const json& before, const json& after) {
  return compareReports(before, "old.json", after, "new.json", 0.05);
}

RowVerdict verdictOn(double before, double after) {
  return compare(reportOf({row("x", before)}), reportOf({row("x", after)})).rows.at(0).verdict;
}

TEST_CASE("a row counts as slower or faster only beyond the threshold") {
  CHECK(verdictOn(100, 100) == RowVerdict::alike);
  CHECK(verdictOn(100, 95.1) == RowVerdict::alike);
  CHECK(verdictOn(100, 94.9) == RowVerdict::slower);
  CHECK(verdictOn(100, 104.9) == RowVerdict::alike);
  CHECK(verdictOn(100, 105.1) == RowVerdict::faster);
}

TEST_CASE("a change within the spread of both runs is undecided, and no regression") {
  json before = row("x", 100), after = row("x", 60);
  before["spread"] = 0.2;
  after["spread"] = 0.41;
  const ReportComparison comparison = compare(reportOf({before}), reportOf({after}));
  CHECK(comparison.rows.at(0).verdict == RowVerdict::undecided);
  CHECK_FALSE(comparison.regressed());
  CHECK_THAT(toText(comparison), Contains("undecided") && Contains("more repetitions"));
  CHECK(compare(reportOf({after}), reportOf({before})).rows.at(0).verdict == RowVerdict::undecided);
  after["spread"] = 0.38;  // 100 / 60 > 1.2 * 1.38
  CHECK(compare(reportOf({before}), reportOf({after})).regressed());
}

TEST_CASE("a report regresses if and only if a row is slower, missing or without its score") {
  const json before = reportOf({row("x", 10), row("y", 10)});
  CHECK_FALSE(compare(before, before).regressed());
  CHECK_FALSE(compare(before, reportOf({row("x", 20), row("y", 10), row("z", 1)})).regressed());
  CHECK(compare(before, reportOf({row("x", 10), row("y", 9)})).regressed());
  CHECK(compare(before, reportOf({row("y", 10)})).regressed());
  json without = row("x", 10);
  without.erase("mraysPerSecond");
  CHECK(compare(before, reportOf({without, row("y", 10)})).regressed());
  CHECK_FALSE(compare(reportOf({without, row("y", 10)}), before).regressed());
}

TEST_CASE("rows are matched by their identity, regardless of their order and of the chosen number of segments") {
  json other = row("x", 10);
  other["segmentsPerDispatch"] = 64;
  const ReportComparison comparison = compare(reportOf({row("x", 10), row("y", 5)}), reportOf({row("y", 5), other}));
  REQUIRE(comparison.rows.size() == 2);
  CHECK(comparison.rows[0].verdict == RowVerdict::alike);
  CHECK(comparison.rows[1].verdict == RowVerdict::alike);
}

TEST_CASE("another scene under the same name is reported, but is not a regression") {
  json changed = row("x", 1);
  changed["sceneHash"] = "2";
  const ReportComparison comparison = compare(reportOf({row("x", 10)}), reportOf({changed}));
  CHECK(comparison.rows.at(0).verdict == RowVerdict::changed);
  CHECK_FALSE(comparison.regressed());
  CHECK_THAT(toText(comparison), Contains("another scene"));
}

TEST_CASE("a report of an earlier version is compared under the names of today") {
  json before = reportOf({row("x", 10)}), after = before;
  before["schema"] = "candela-bench/1";
  before["rows"][0].update({{"rays", "primary"}, {"layout", "row"}});
  after["rows"][0].update({{"rayKind", "primary"}, {"layout", "list"}});
  const ReportComparison comparison = compare(before, after);
  REQUIRE(comparison.rows.size() == 1);
  CHECK(comparison.rows.at(0).name == "a.p3f, x, primary, list");
  CHECK(comparison.rows.at(0).verdict == RowVerdict::alike);
}

TEST_CASE("a file that is no report is refused, and the message names it") {
  const json good = reportOf({});
  for (const json& bad :
       {json::object(), json::array(), json(3), json{{"schema", "other/1"}}, json{{"schema", "candela-bench/2"}},
        reportOf({json::object()}), reportOf({json(1)}), json{{"schema", "candela-bench/2"}, {"rows", 3}},
        json{{"schema", 2}, {"rows", json::array()}}}) {
    INFO(bad.dump());
    CHECK_THROWS_AS(compare(good, bad), FileError);
    CHECK_THROWS_WITH(compare(bad, good), Contains("old.json: not a report of candela bench"));
  }
}

TEST_CASE("a member of a report that has another type is refused by its pointer") {
  json report = reportOf({row("x", 10)});
  const auto refuses = [&](const json& bad, const std::string& message) {
    CHECK_THROWS_WITH(compare(report, bad), "new.json: not a report of candela bench: " + message);
  };
  for (const char* const member : {"device", "driver"}) {
    json bad = report;
    bad[member] = 547776;
    refuses(bad, std::string("/") + member + ": expected a string");
  }
  json bad = report;
  bad["rows"][0]["sceneHash"] = json::array();
  refuses(bad, "/rows/0/sceneHash: expected a string");
  bad = report;
  bad["rows"][0]["spread"] = "1";
  refuses(bad, "/rows/0/spread: expected a number");
  bad["rows"][0]["spread"] = nullptr;
  CHECK_NOTHROW(compare(report, bad));
}

TEST_CASE("a report that is nested too deeply is refused before it is parsed") {
  const TemporaryFolder folder;
  const auto write = [&](std::size_t depth) {
    std::ofstream(folder / "a.json") << R"({"schema":"candela-bench/2","rows":[{"sceneHash":"1","scene":)"
                                     << std::string(depth, '[') << std::string(depth, ']') << "}]}";
    return folder / "a.json";
  };
  CHECK_THROWS_WITH(readReport(write(300000)), Contains("a.json:1:315: JSON is nested more than 256 levels deep"));
  CHECK_THROWS_WITH(readReport(write(254)), Contains("256 levels"));
  CHECK_NOTHROW(readReport(write(253)));
}

TEST_CASE("the comparison's text and JSON have both scores and the change") {
  const ReportComparison comparison = compare(reportOf({row("x", 10)}), reportOf({row("x", 8)}));
  CHECK_THAT(toText(comparison), Contains("10.000") && Contains("8.000") && Contains("-20.0 %") && Contains("slower") &&
                                     Contains("1 of 1 rows slower by more than 5 %"));
  CHECK(toJson(comparison)["agrees"] == false);
  CHECK(toJson(comparison)["rows"][0]["newMraysPerSecond"] == 8);
}

}  // namespace
}  // namespace candela::bench

// The comparison of two reports as text, Markdown and JSON.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "host/base/report_head.h"
#include "host/measure/bench/comparison_text.h"
#include "host/measure/bench/report_comparison.h"
#include "host/measure/bench/text_table.h"

namespace candela::bench {
namespace {

const char* wordFor(RowVerdict verdict) {
  switch (verdict) {
    case RowVerdict::alike:
      return "alike";
    case RowVerdict::faster:
      return "faster";
    case RowVerdict::slower:
      return "slower";
    case RowVerdict::undecided:
      return "undecided";
    case RowVerdict::missing:
      return "missing";
    case RowVerdict::added:
      return "added";
    case RowVerdict::changed:
      break;
  }
  return "another scene";
}

std::string scoreText(const std::optional<double>& score) { return score ? fmt::format("{:.3f}", *score) : ""; }

TextTable tableOf(const ReportComparison& comparison) {
  TextTable table;
  table.header = {"row", "old Mrays/s", "new Mrays/s", "change", "spread", "verdict"};
  for (const ComparedRow& row : comparison.rows) {
    table.rows.push_back({row.name, scoreText(row.oldScore), scoreText(row.newScore),
                          changeText(row.oldScore, row.newScore), fmt::format("{:.0f} %", 100 * row.spread),
                          wordFor(row.verdict)});
  }
  return table;
}

std::string headline(const ReportComparison& comparison) {
  const auto regressions = std::count_if(comparison.rows.begin(), comparison.rows.end(), isRegression);
  const auto undecided = std::ranges::count(comparison.rows, RowVerdict::undecided, &ComparedRow::verdict);
  const std::string hint = undecided == 0 ? ""
                                          : fmt::format(
                                                "; {} undecided, since the change is within the spread of the "
                                                "runs: measure both reports with more repetitions",
                                                undecided);
  return fmt::format("{}\n{} of {} rows slower by more than {:.3g} %, or missing{}",
                     devicesText(comparison.oldDevice, comparison.newDevice), regressions, comparison.rows.size(),
                     100 * comparison.threshold, hint);
}

}  // namespace

std::string toText(const ReportComparison& comparison) {
  return headline(comparison) + "\n\n" + toText(tableOf(comparison));
}

std::string toMarkdown(const ReportComparison& comparison) {
  return headline(comparison) + "\n\n" + toMarkdown(tableOf(comparison));
}

nlohmann::ordered_json toJson(const ReportComparison& comparison) {
  nlohmann::ordered_json result = reportHead("candela-bench-comparison/2");
  result["oldDevice"] = comparison.oldDevice;
  result["newDevice"] = comparison.newDevice;
  result["threshold"] = comparison.threshold;
  result["agrees"] = !comparison.regressed();
  result["rows"] = nlohmann::ordered_json::array();
  for (const ComparedRow& row : comparison.rows) {
    nlohmann::ordered_json line;
    line["row"] = row.name;
    if (row.oldScore) line["oldMraysPerSecond"] = *row.oldScore;
    if (row.newScore) line["newMraysPerSecond"] = *row.newScore;
    line["spread"] = row.spread;
    line["verdict"] = wordFor(row.verdict);
    result["rows"].push_back(std::move(line));
  }
  return result;
}

}  // namespace candela::bench

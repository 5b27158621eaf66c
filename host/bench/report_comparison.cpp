// Compares two reports of a benchmark row by row.
#include "host/bench/report_comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "host/bench/render_rows.h"
#include "host/bench/text_table.h"
#include "host/core/errors.h"
#include "host/core/report_head.h"

namespace candela::bench {
namespace {

using nlohmann::json;

// The fields that identify a row in both reports, in the order of its name. The number of segments per dispatch is not
// one of them, since by default it is chosen by timing.
constexpr std::array kIdentity{"scene",    "size",       "samplesPerPixel", "variant", "rayKind",    "structure",
                               "bvhSplit", "bvhQuality", "kernel",          "layout",  "sceneLoads", "workgroup"};

/// The schema of earlier versions, whose rows have the same scores.
constexpr const char* kOldSchema = "candela-bench/1";

struct Row {
  std::string name;
  std::string sceneHash;
  std::optional<double> score;
  double spread = 0;
};

// Gives a row of an earlier version the names of today.
json renamed(json row) {
  if (const auto kind = row.find("rays"); kind != row.end()) row["rayKind"] = *kind;
  if (const auto layout = row.find("layout"); layout != row.end() && (*layout == "row" || *layout == "none")) {
    *layout = "list";
  }
  return row;
}

std::string nameOf(const json& row) {
  std::string name;
  for (const char* const key : kIdentity) {
    const auto field = row.find(key);
    if (field == row.end()) continue;
    const std::string text = field->is_string() ? field->get<std::string>() : field->dump();
    if (text.empty()) continue;
    if (!name.empty()) name += ", ";
    name += text;
  }
  return name;
}

template <class T>
std::optional<T> fieldOf(const json& row, const char* key) {
  const auto field = row.find(key);
  return field == row.end() || field->is_null() ? std::nullopt : std::optional(field->get<T>());
}

std::vector<Row> readRows(const json& report, const std::string& name) {
  try {
    if (report.at("schema") != kBenchSchema && report.at("schema") != kOldSchema)
      throw FileError(name + ": not a report of candela bench: it has another schema");
    std::vector<Row> rows;
    for (const json& row : report.at("rows")) {
      rows.push_back({nameOf(renamed(row)), row.at("sceneHash").get<std::string>(),
                      fieldOf<double>(row, "mraysPerSecond"), fieldOf<double>(row, "spread").value_or(0)});
    }
    return rows;
  } catch (const json::exception& error) {
    throw FileError(fmt::format("{}: not a report of candela bench: {}", name, error.what()));
  }
}

std::string deviceOf(const json& report) {
  return fieldOf<std::string>(report, "device").value_or("") + ", " +
         fieldOf<std::string>(report, "driver").value_or("");
}

// The times of each row vary by its spread, so that their ratio may vary by both.
bool isWithinSpread(const Row& before, const Row& after) {
  const double ratio = *after.score / *before.score;
  return std::max(ratio, 1 / ratio) <= (1 + before.spread) * (1 + after.spread);
}

RowVerdict judge(const Row& before, const Row& after, double threshold) {
  if (before.sceneHash != after.sceneHash) return RowVerdict::changed;
  if (!before.score || !after.score) {
    if (before.score.has_value() == after.score.has_value()) return RowVerdict::alike;
    return before.score ? RowVerdict::missing : RowVerdict::added;
  }
  const bool isSlower = *after.score < *before.score * (1 - threshold);
  const bool isFaster = *after.score > *before.score * (1 + threshold);
  if (!isSlower && !isFaster) return RowVerdict::alike;
  if (isWithinSpread(before, after)) return RowVerdict::undecided;
  return isSlower ? RowVerdict::slower : RowVerdict::faster;
}

const Row* find(const std::vector<Row>& rows, const std::string& name) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const Row& row) { return row.name == name; });
  return found == rows.end() ? nullptr : &*found;
}

bool isRegression(const ComparedRow& row) {
  return row.verdict == RowVerdict::slower || row.verdict == RowVerdict::missing;
}

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

std::string changeText(const ComparedRow& row) {
  if (!row.oldScore || !row.newScore || *row.oldScore <= 0) return "";
  return fmt::format("{:+.1f} %", 100 * (*row.newScore / *row.oldScore - 1));
}

TextTable tableOf(const ReportComparison& comparison) {
  TextTable table;
  table.header = {"row", "old Mrays/s", "new Mrays/s", "change", "spread", "verdict"};
  for (const ComparedRow& row : comparison.rows) {
    table.rows.push_back({row.name, scoreText(row.oldScore), scoreText(row.newScore), changeText(row),
                          fmt::format("{:.0f} %", 100 * row.spread), wordFor(row.verdict)});
  }
  return table;
}

std::string headline(const ReportComparison& comparison) {
  const std::string devices = comparison.oldDevice == comparison.newDevice
                                  ? comparison.newDevice
                                  : comparison.oldDevice + " before, now " + comparison.newDevice;
  const auto regressions = std::count_if(comparison.rows.begin(), comparison.rows.end(), isRegression);
  const auto undecided = std::ranges::count(comparison.rows, RowVerdict::undecided, &ComparedRow::verdict);
  const std::string hint = undecided == 0 ? ""
                                          : fmt::format(
                                                "; {} undecided, since the change is within the spread of the "
                                                "runs: measure both reports with a larger --repeat",
                                                undecided);
  return fmt::format("{}\n{} of {} rows slower by more than {:.3g} %, or missing{}", devices, regressions,
                     comparison.rows.size(), 100 * comparison.threshold, hint);
}

}  // namespace

bool ReportComparison::regressed() const { return std::any_of(rows.begin(), rows.end(), isRegression); }

ReportComparison compareReports(const json& oldReport, const std::string& oldName, const json& newReport,
                                const std::string& newName, double threshold) {
  const std::vector<Row> before = readRows(oldReport, oldName);
  const std::vector<Row> after = readRows(newReport, newName);
  ReportComparison comparison{deviceOf(oldReport), deviceOf(newReport), threshold, {}};
  for (const Row& row : before) {
    const Row* const counterpart = find(after, row.name);
    if (counterpart == nullptr) {
      comparison.rows.push_back({row.name, row.score, {}, row.spread, RowVerdict::missing});
    } else {
      comparison.rows.push_back({row.name, row.score, counterpart->score, std::max(row.spread, counterpart->spread),
                                 judge(row, *counterpart, threshold)});
    }
  }
  for (const Row& row : after) {
    if (find(before, row.name) == nullptr)
      comparison.rows.push_back({row.name, {}, row.score, row.spread, RowVerdict::added});
  }
  return comparison;
}

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

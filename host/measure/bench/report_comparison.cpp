// Compares two reports of a benchmark row by row.
#include "host/measure/bench/report_comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/base/errors.h"
#include "host/base/json_text.h"
#include "host/base/json_value.h"
#include "host/measure/bench/render_rows.h"

namespace candela::bench {
namespace {

struct ReportRow {
  std::string name;  ///< scene and settings, which identify the row in both reports
  std::string sceneHash;
  std::optional<double> score;  ///< millions of rays per second
  double spread = 0;
};

struct ReportContent {
  std::string device;  ///< and driver
  std::vector<ReportRow> rows;
};

using nlohmann::json;

// The fields that identify a row in both reports, in the order of its name. The number of segments per dispatch is not
// one of them, since by default it is chosen by timing.
constexpr std::array kIdentity{"scene",    "size",       "samplesPerPixel", "variant", "rayKind",    "structure",
                               "bvhSplit", "bvhQuality", "kernel",          "layout",  "sceneLoads", "workgroup"};

/// The schema of earlier versions, whose rows have the same scores.
constexpr const char* kOldSchema = "candela-bench/1";

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
    const std::string text = field->is_string() ? field->get<std::string>() : jsonText(*field);
    if (text.empty()) continue;
    if (!name.empty()) name += ", ";
    name += text;
  }
  return name;
}

std::optional<double> numberIn(const JsonValue& row, const char* key) {
  const JsonValue value = row.findOrNull(key);
  return value.isNull() ? std::nullopt : std::optional(value.number());
}

ReportRow rowIn(const JsonValue& row) {
  return {nameOf(renamed(row.json())), row.require("sceneHash").text(), numberIn(row, "mraysPerSecond"),
          numberIn(row, "spread").value_or(0)};
}

/// Throws FileError if the report has neither kBenchSchema nor its predecessor, or if a member is none of such a
/// report. `name` is that of its file.
ReportContent readContent(const json& report, const std::string& name) {
  try {
    const JsonValue root(report, "");
    const JsonValue schema = root.require("schema");
    if (schema.text() != kBenchSchema && schema.text() != kOldSchema) schema.fail("it has another schema");
    ReportContent content{root.textOr("device", "") + ", " + root.textOr("driver", ""), {}};
    for (const JsonValue& row : root.require("rows").items()) content.rows.push_back(rowIn(row));
    return content;
  } catch (const JsonError& error) {
    throw FileError(fmt::format("{}: not a report of candela bench: {}", name, error.what()));
  }
}

using nlohmann::json;

// The times of each row vary by its spread, so that their ratio may vary by both.
bool isWithinSpread(const ReportRow& before, const ReportRow& after) {
  const double ratio = *after.score / *before.score;
  return std::max(ratio, 1 / ratio) <= (1 + before.spread) * (1 + after.spread);
}

RowVerdict judge(const ReportRow& before, const ReportRow& after, double threshold) {
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

const ReportRow* find(const std::vector<ReportRow>& rows, const std::string& name) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const ReportRow& row) { return row.name == name; });
  return found == rows.end() ? nullptr : &*found;
}

}  // namespace

bool isRegression(const ComparedRow& row) {
  return row.verdict == RowVerdict::slower || row.verdict == RowVerdict::missing;
}

bool ReportComparison::regressed() const { return std::any_of(rows.begin(), rows.end(), isRegression); }

ReportComparison compareReports(const json& oldReport, const std::string& oldName, const json& newReport,
                                const std::string& newName, double threshold) {
  const ReportContent old = readContent(oldReport, oldName), current = readContent(newReport, newName);
  const std::vector<ReportRow>&before = old.rows, &after = current.rows;
  ReportComparison comparison{old.device, current.device, threshold, {}};
  for (const ReportRow& row : before) {
    const ReportRow* const counterpart = find(after, row.name);
    if (counterpart == nullptr) {
      comparison.rows.push_back({row.name, row.score, {}, row.spread, RowVerdict::missing});
    } else {
      comparison.rows.push_back({row.name, row.score, counterpart->score, std::max(row.spread, counterpart->spread),
                                 judge(row, *counterpart, threshold)});
    }
  }
  for (const ReportRow& row : after) {
    if (find(before, row.name) == nullptr)
      comparison.rows.push_back({row.name, {}, row.score, row.spread, RowVerdict::added});
  }
  return comparison;
}

}  // namespace candela::bench

// Compares two reports of a benchmark row by row.
#include "host/measure/bench/report_comparison.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "host/measure/bench/report_rows.h"

namespace candela::bench {
namespace {

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

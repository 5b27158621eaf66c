// Compares two reports of kernels figure by figure.
#include "host/drivers/kernels/kernel_comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "host/base/errors.h"
#include "host/base/json_value.h"
#include "host/drivers/kernels/kernel_report.h"

namespace candela::kernels {
namespace {

using nlohmann::json;

struct ReportRow {
  std::string name;
  std::string sceneHash;
  Figures figures;
};

struct ReportContent {
  std::string device;  ///< and driver
  std::string driverName;
  std::vector<ReportRow> rows;
};

ReportRow rowIn(const JsonValue& row) {
  ReportRow result{fmt::format("{}, {}, {}", row.require("scene").text(), row.require("kernel").text(),
                               row.require("workgroup").text()),
                   row.require("sceneHash").text(),
                   {}};
  for (const FigureInfo& figure : kFigures) {
    const JsonValue value = row.findOrNull(figure.key);
    if (!value.isNull()) result.figures.*figure.member = value.number();
  }
  return result;
}

// `name` is that of the file.
ReportContent readContent(const json& report, const std::string& name) {
  try {
    const JsonValue root(report, "");
    const JsonValue schema = root.require("schema");
    if (schema.text() != kKernelsSchema) schema.fail("it has another schema");
    ReportContent content{
        root.require("device").text() + ", " + root.require("driver").text(), root.require("driverName").text(), {}};
    for (const JsonValue& row : root.require("rows").items()) content.rows.push_back(rowIn(row));
    return content;
  } catch (const JsonError& error) {
    throw FileError(fmt::format("{}: not a report of candela kernels: {}", name, error.what()));
  }
}

bool isWithin(const FigureChange& change, double threshold) {
  if (!change.oldValue || !change.newValue) return false;
  const auto [low, high] = std::minmax(*change.oldValue, *change.newValue);
  return high <= low * (1 + threshold);
}

FigureVerdict judge(const FigureChange& change, double threshold) {
  if (change.figure->better == Better::notJudged || !change.oldValue) return FigureVerdict::changed;
  if (!change.newValue) return FigureVerdict::missing;
  if (isWithin(change, threshold)) return FigureVerdict::changed;
  const bool isHigher = *change.newValue > *change.oldValue;
  return isHigher == (change.figure->better == Better::higher) ? FigureVerdict::better : FigureVerdict::worse;
}

ComparedRow compareRows(const ReportRow& before, const ReportRow& after, bool isOneDriver, double threshold) {
  ComparedRow row{before.name, RowState::compared, {}};
  if (before.sceneHash != after.sceneHash) {
    row.state = RowState::anotherScene;
    return row;
  }
  for (const FigureInfo& figure : kFigures) {
    FigureChange change{&figure, before.figures.*figure.member, after.figures.*figure.member};
    if (change.oldValue == change.newValue || !(isOneDriver || figure.isOfAllDrivers)) continue;
    if (figure.member == &Figures::compileSeconds && isWithin(change, threshold)) continue;  // it always differs
    change.verdict = judge(change, threshold);
    row.changes.push_back(change);
  }
  return row;
}

const ReportRow* find(const std::vector<ReportRow>& rows, const std::string& name) {
  const auto found = std::ranges::find(rows, name, &ReportRow::name);
  return found == rows.end() ? nullptr : &*found;
}

bool isRegression(const ComparedRow& row) {
  return row.state == RowState::missing || std::ranges::any_of(row.changes, [](const FigureChange& change) {
           return change.verdict == FigureVerdict::worse || change.verdict == FigureVerdict::missing;
         });
}

}  // namespace

bool KernelComparison::regressed() const { return std::ranges::any_of(rows, isRegression); }

KernelComparison compareReports(const json& oldReport, const std::string& oldName, const json& newReport,
                                const std::string& newName, double threshold) {
  const ReportContent before = readContent(oldReport, oldName), after = readContent(newReport, newName);
  KernelComparison comparison{before.device, after.device, before.driverName == after.driverName, threshold, {}};
  for (const ReportRow& row : before.rows) {
    const ReportRow* const counterpart = find(after.rows, row.name);
    comparison.rows.push_back(counterpart == nullptr
                                  ? ComparedRow{row.name, RowState::missing, {}}
                                  : compareRows(row, *counterpart, comparison.isOneDriver, threshold));
  }
  for (const ReportRow& row : after.rows) {
    if (find(before.rows, row.name) == nullptr) comparison.rows.push_back({row.name, RowState::added, {}});
  }
  return comparison;
}

}  // namespace candela::kernels

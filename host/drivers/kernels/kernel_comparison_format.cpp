// The comparison of two reports of kernels as text, Markdown and JSON.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "host/base/report_head.h"
#include "host/drivers/kernels/kernel_comparison.h"
#include "host/drivers/kernels/kernel_report.h"
#include "host/measure/bench/comparison_text.h"
#include "host/measure/bench/text_table.h"

namespace candela::kernels {
namespace {

const char* wordFor(FigureVerdict verdict) {
  switch (verdict) {
    case FigureVerdict::better:
      return "better";
    case FigureVerdict::worse:
      return "worse";
    case FigureVerdict::missing:
      return "missing";
    case FigureVerdict::changed:
      break;
  }
  return "changed";
}

const char* wordFor(RowState state) {
  switch (state) {
    case RowState::compared:
      return "compared";
    case RowState::missing:
      return "missing";
    case RowState::added:
      return "added";
    case RowState::anotherScene:
      break;
  }
  return "another scene";
}

bench::TextTable tableOf(const KernelComparison& comparison) {
  bench::TextTable table{{"kernel", "figure", "old", "new", "change", "verdict"}, {}};
  for (const ComparedRow& row : comparison.rows) {
    if (row.state != RowState::compared) table.rows.push_back({row.name, "", "", "", "", wordFor(row.state)});
    for (const FigureChange& change : row.changes) {
      table.rows.push_back({row.name, change.figure->title, figureText(*change.figure, change.oldValue),
                            figureText(*change.figure, change.newValue),
                            bench::changeText(change.oldValue, change.newValue), wordFor(change.verdict)});
    }
  }
  return table;
}

std::string headline(const KernelComparison& comparison) {
  std::string text = bench::devicesText(comparison.oldDevice, comparison.newDevice);
  if (!comparison.isOneDriver)
    text += "\nThe drivers have different units, so that only figures that all drivers share are compared.";
  return fmt::format("{}\n{}", text,
                     comparison.regressed()
                         ? fmt::format("worse by more than {:.3g} %, or missing", 100 * comparison.threshold)
                         : fmt::format("no figure worse by more than {:.3g} %", 100 * comparison.threshold));
}

nlohmann::ordered_json toJson(const std::optional<double>& value) {
  return value ? nlohmann::ordered_json(*value) : nullptr;
}

nlohmann::ordered_json toJson(const ComparedRow& row) {
  nlohmann::ordered_json line{{"row", row.name}, {"state", wordFor(row.state)}};
  line["changes"] = nlohmann::ordered_json::array();
  for (const FigureChange& change : row.changes) {
    line["changes"].push_back({{"figure", change.figure->key},
                               {"old", toJson(change.oldValue)},
                               {"new", toJson(change.newValue)},
                               {"verdict", wordFor(change.verdict)}});
  }
  return line;
}

}  // namespace

std::string toText(const KernelComparison& comparison) {
  return headline(comparison) + "\n\n" + toText(tableOf(comparison));
}

std::string toMarkdown(const KernelComparison& comparison) {
  return headline(comparison) + "\n\n" + toMarkdown(tableOf(comparison));
}

nlohmann::ordered_json toJson(const KernelComparison& comparison) {
  nlohmann::ordered_json result = reportHead("candela-kernels-comparison/1");
  result["oldDevice"] = comparison.oldDevice;
  result["newDevice"] = comparison.newDevice;
  result["threshold"] = comparison.threshold;
  result["agrees"] = !comparison.regressed();
  result["rows"] = nlohmann::ordered_json::array();
  for (const ComparedRow& row : comparison.rows) result["rows"].push_back(toJson(row));
  return result;
}

}  // namespace candela::kernels

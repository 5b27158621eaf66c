// Formats the error in equal time.
#include "host/measure/bench/error_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "host/base/report_head.h"
#include "host/base/version.h"
#include "host/measure/bench/text_table.h"

namespace candela::bench {
namespace {

using nlohmann::ordered_json;

const ErrorRow& firstOfScene(const ErrorReport& report, const ErrorRow& row) {
  return *std::ranges::find(report.rows, row.scene, &ErrorRow::scene);
}

// Returns the error relative to that of the first tracer of the scene, in equal time by the clock or of the processor.
std::optional<ConfidentValue> ratioOf(const ErrorReport& report, const ErrorRow& row, bool ofProcessor) {
  const ErrorRow& first = firstOfScene(report, row);
  if (&first == &row) return std::nullopt;
  if (!ofProcessor) return errorRatio(row.error, first.error);
  if (!row.processorError || !first.processorError) return std::nullopt;
  return errorRatio(*row.processorError, *first.processorError);
}

std::string timesText(const std::optional<ConfidentValue>& ratio) {
  return ratio ? fmt::format("{:.2f} ({:.2f} to {:.2f})", ratio->value, ratio->low, ratio->high) : "";
}

TextTable tableOf(const ErrorReport& report) {
  TextTable table;
  table.header = {"scene",
                  "tracer",
                  "samples",
                  "pictures",
                  "s",
                  "CPU s",
                  "relMSE",
                  "error after 1 s",
                  "relative to the first",
                  "error after 1 CPU s",
                  "relative to the first"};
  for (const ErrorRow& row : report.rows) {
    table.rows.push_back({row.scene, row.tracer, fmt::format("{}", row.samplesPerPixel),
                          fmt::format("{}", row.pictureCount), fmt::format("{:.3g}", row.medianSeconds),
                          row.medianProcessorSeconds ? fmt::format("{:.3g}", *row.medianProcessorSeconds) : "",
                          fmt::format("{:.3g}", row.error.relMse().value), percentText(row.error.errorAfterSecond()),
                          timesText(ratioOf(report, row, false)),
                          row.processorError ? percentText(row.processorError->errorAfterSecond()) : "",
                          timesText(ratioOf(report, row, true))});
  }
  return table;
}

// States how well the tracers agree on the picture, without which their errors could not be compared.
std::string referencesText(const ErrorReport& report) {
  std::string text;
  for (const ErrorRow& row : report.rows) {
    const ErrorRow& first = firstOfScene(report, row);
    if (&first == &row) continue;
    text += fmt::format("{}: converged pictures of {} and {} differ by a relMSE of {:.2g} without noise\n", row.scene,
                        row.tracer, first.tracer, row.referenceRelMse);
  }
  return text;
}

std::string headline() {
  return fmt::format("candela {}; medians of times, 95 % confidence in parentheses", versionText());
}

}  // namespace

std::string percentText(const ConfidentValue& fraction) {
  return fmt::format("{:.3g} % ({:.3g} to {:.3g})", 100 * fraction.value, 100 * fraction.low, 100 * fraction.high);
}

void addInterval(const std::string& name, const ConfidentValue& estimate, ordered_json& json) {
  json[name] = estimate.value;
  json[name + "Low"] = estimate.low;
  json[name + "High"] = estimate.high;
}

std::string toText(const ErrorReport& report) {
  return headline() + "\n\n" + toText(tableOf(report)) + "\n" + referencesText(report);
}

std::string toMarkdown(const ErrorReport& report) {
  return headline() + "\n\n" + toMarkdown(tableOf(report)) + "\n" + referencesText(report);
}

ordered_json toJson(const ErrorReport& report) {
  ordered_json json = reportHead("candela-bench-error/1");
  json["rows"] = ordered_json::array();
  for (const ErrorRow& row : report.rows) {
    ordered_json one{{"scene", row.scene},           {"tracer", row.tracer},
                     {"tracerVersion", row.version}, {"samplesPerPixel", row.samplesPerPixel},
                     {"pictures", row.pictureCount}, {"medianSeconds", row.medianSeconds},
                     {"processorSeconds", nullptr}};
    if (row.medianProcessorSeconds) one["processorSeconds"] = *row.medianProcessorSeconds;
    addInterval("relMse", row.error.relMse(), one);
    addInterval("errorAfterSecond", row.error.errorAfterSecond(), one);
    if (const auto ratio = ratioOf(report, row, false)) addInterval("errorRatio", *ratio, one);
    if (row.processorError) addInterval("errorAfterProcessorSecond", row.processorError->errorAfterSecond(), one);
    if (const auto ratio = ratioOf(report, row, true)) addInterval("processorErrorRatio", *ratio, one);
    one["referenceRelMse"] = row.referenceRelMse;
    json["rows"].push_back(std::move(one));
  }
  return json;
}

}  // namespace candela::bench

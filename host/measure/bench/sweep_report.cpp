// Formats the benchmark of whole renders.
#include "host/measure/bench/sweep_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "host/base/statistics/quantiles.h"
#include "host/base/version.h"
#include "host/judge/report/bar_chart.h"
#include "host/measure/bench/error_report.h"
#include "host/measure/bench/text_table.h"

namespace candela::bench {
namespace {

using nlohmann::ordered_json;
using statistics::median;
using statistics::spread;

double raysPerSample(const Measurement& m) {
  return m.statistics.samples > 0 ? static_cast<double>(m.statistics.rays()) / static_cast<double>(m.statistics.samples)
                                  : 0;
}

std::vector<std::string> sweepFigures(const Measurement& m) {
  if (!m.agrees) return {"differs", "", "", "", "", "", "", ""};
  return {fmt::format("{:.1f}", 1e3 * median(m.traceSeconds)),
          fmt::format("{:.0f} %", 100 * spread(m.traceSeconds)),
          fmt::format("{:.3f}", m.msamplesPerSecond()),
          fmt::format("{:.2f}", m.mraysPerSecond()),
          fmt::format("{:.2f}", raysPerSample(m)),
          m.relMse ? fmt::format("{:.3g}", *m.relMse) : "",
          m.relMse ? fmt::format("{:.3g}", m.efficiency()) : "",
          m.error ? percentText(m.error->errorAfterSecond()) : ""};
}

TextTable tableOf(const SweepReport& report) {
  TextTable table;
  table.header = {"scene",   "variant",         "ms",     "spread",       "Msamples/s",
                  "Mrays/s", "rays per sample", "relMSE", "1/(s relMSE)", "error after 1 s"};
  for (const RenderRow& row : report.rows) {
    std::vector<std::string> cells{row.scene, row.measurement.variant.name};
    for (std::string& figure : sweepFigures(row.measurement)) cells.push_back(std::move(figure));
    table.rows.push_back(std::move(cells));
  }
  if (std::ranges::none_of(report.rows, [](const RenderRow& row) { return row.measurement.error.has_value(); })) {
    table.header.pop_back();
    for (std::vector<std::string>& cells : table.rows) cells.pop_back();
  }
  return table;
}

// Returns the fastest variant among the rows of one scene, starting at `from`, and moves `from` past them.
const RenderRow* fastestOfScene(const SweepReport& report, std::size_t& from) {
  const RenderRow* fastest = nullptr;
  const RenderRow& start = report.rows[from];
  for (; from < report.rows.size() && report.rows[from].scene == start.scene; ++from) {
    const RenderRow& row = report.rows[from];
    if (!row.measurement.agrees) continue;
    if (fastest == nullptr || row.measurement.msamplesPerSecond() > fastest->measurement.msamplesPerSecond())
      fastest = &row;
  }
  return fastest;
}

std::string lineOf(const RenderRow& row, std::uint32_t repeats) {
  const Measurement& m = row.measurement;
  const render::RenderStatistics& s = m.statistics;
  return fmt::format(
      "candela {} | {} | {} {} x {} spp | {} | {:.3f} Msamples/s, {:.2f} Mrays/s | median of {}, spread {:.0f} %\n",
      versionText(), s.driver.empty() ? s.device : s.driver, row.scene, extentText(m.variant.settings.image.size),
      m.variant.settings.image.sampleCount, m.variant.name, m.msamplesPerSecond(), m.mraysPerSecond(), repeats,
      100 * spread(m.traceSeconds));
}

std::string linesToPaste(const SweepReport& report) {
  std::string lines;
  for (std::size_t from = 0; from < report.rows.size();) {
    if (const RenderRow* const row = fastestOfScene(report, from)) lines += lineOf(*row, report.repeats);
  }
  return lines;
}

report::Bar barOf(const Measurement& m) {
  if (!m.agrees) return {m.variant.name + " (differs)", 0, 0, 0};
  const double samples = static_cast<double>(m.statistics.samples) * 1e-6;
  return {m.variant.name, m.msamplesPerSecond(), samples / m.traceSeconds.back(), samples / m.traceSeconds.front()};
}

}  // namespace

std::string toText(const SweepReport& report) {
  return headline(report) + "\n\n" + toText(tableOf(report)) + "\n" + linesToPaste(report);
}

std::string toMarkdown(const SweepReport& report) { return headline(report) + "\n\n" + toMarkdown(tableOf(report)); }

ordered_json toJson(const SweepReport& report) {
  ordered_json json = reportJson(report);
  json["processBytes"] = report.processBytes;
  json["rows"] = rowsJson(report);
  return json;
}

std::string toSvg(const SweepReport& report) {
  std::vector<report::BarGroup> groups;
  for (const RenderRow& row : report.rows) {
    if (groups.empty() || groups.back().title != row.scene) groups.push_back({row.scene, {}});
    groups.back().bars.push_back(barOf(row.measurement));
  }
  return report::barChart(headline(report), "Msamples/s", groups);
}

}  // namespace candela::bench

// Formats the benchmark of rays.
#include "host/measure/bench/ray_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "host/base/hash_text.h"
#include "host/base/statistics/quantiles.h"
#include "host/base/version.h"
#include "host/measure/bench/measure.h"
#include "host/measure/bench/render_rows.h"
#include "host/measure/bench/text_table.h"

namespace candela::bench {
namespace {

using nlohmann::ordered_json;
using statistics::median;
using statistics::spread;

bool agrees(const RayRow& row) { return row.measurement.equalFraction >= row.minEqualFraction; }

std::vector<std::string> rayFigures(const RayRow& row) {
  const RayMeasurement& m = row.measurement;
  if (!agrees(row)) return {fmt::format("{}", m.rayCount), "", "differs", "", "", ""};
  return {fmt::format("{}", m.rayCount),
          fmt::format("{:.1f}", 1e3 * median(m.seconds)),
          fmt::format("{:.0f} %", 100 * spread(m.seconds)),
          fmt::format("{:.3f}", m.mraysPerSecond()),
          fmt::format("{:.3f}", m.mraysPerProcessorSecond()),
          fmt::format("{:.1f}", m.stepsPerRay)};
}

TextTable tableOf(const RayReport& report) {
  TextTable table;
  table.header = {"scene", "rays",   "layout",  "loads",           "MiB",          "count",
                  "ms",    "spread", "Mrays/s", "Mrays per CPU s", "steps per ray"};
  for (const RayRow& row : report.rows) {
    std::vector<std::string> cells{row.scene, rayKindName(row.measurement.kind), row.tracer, nameOf(row.sceneLoads),
                                   fmt::format("{:.1f}", static_cast<double>(row.sceneBytes) / (1 << 20))};
    for (std::string& figure : rayFigures(row)) cells.push_back(std::move(figure));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

std::string headline(const RayReport& report) {
  WarmUpWork warmUp;
  std::size_t runs = 0;
  for (const RayRow& row : report.rows) {
    warmUp.add(row.measurement.warmUp);
    runs += row.measurement.seconds.size();
  }
  return fmt::format("candela {} on {}, {}; {} pixels, workgroup {}; {}", versionText(), report.device, report.driver,
                     extentText(report.size), extentText(report.workgroup),
                     repetitionText(report.repeats, warmUp, runs));
}

ordered_json rowJson(const RayReport& report, const RayRow& row) {
  const RayMeasurement& m = row.measurement;
  ordered_json json;
  json["scene"] = row.scene;
  json["sceneHash"] = hashText(row.sceneHash);
  json["rayKind"] = rayKindName(m.kind);
  json["rayCount"] = m.rayCount;
  json["workgroup"] = extentText(report.workgroup);
  json["kernel"] = "rays";
  json["layout"] = row.tracer;
  json["sceneLoads"] = nameOf(row.sceneLoads);
  json["sceneBytes"] = row.sceneBytes;
  json["agrees"] = agrees(row);
  if (agrees(row)) {
    json["medianSeconds"] = median(m.seconds);
    json["spread"] = spread(m.seconds);
    json["warmUpSeconds"] = m.warmUp.seconds;
    json["warmUpPasses"] = m.warmUp.passes;
    json["processorSeconds"] = median(m.processorSeconds);
    json["mraysPerSecond"] = m.mraysPerSecond();
    json["stepsPerRay"] = m.stepsPerRay;
  }
  return json;
}

}  // namespace

bool RayReport::agree() const { return std::all_of(rows.begin(), rows.end(), agrees); }

std::string toText(const RayReport& report) { return headline(report) + "\n\n" + toText(tableOf(report)); }

std::string toMarkdown(const RayReport& report) { return headline(report) + "\n\n" + toMarkdown(tableOf(report)); }

ordered_json toJson(const RayReport& report) {
  ordered_json json = reportJson(kBenchSchema, report.device, report.driver, report.repeats, report.agree());
  json["size"] = extentText(report.size);
  for (const RayRow& row : report.rows) json["rows"].push_back(rowJson(report, row));
  return json;
}

}  // namespace candela::bench

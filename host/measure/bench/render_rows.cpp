// Formats the common parts of reports on renders.
#include "host/measure/bench/render_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "host/base/hash_text.h"
#include "host/base/report_head.h"
#include "host/base/statistics/quantiles.h"
#include "host/base/version.h"
#include "host/measure/bench/error_report.h"

namespace candela::bench {
namespace {

using nlohmann::ordered_json;
using statistics::median;
using statistics::spread;

double perSecond(std::uint64_t count, double seconds) {
  return statistics::ratio(1e-6 * static_cast<double>(count), seconds);
}

ordered_json raysJson(const render::RenderStatistics& statistics, double seconds) {
  return {{"camera", perSecond(statistics.cameraRays, seconds)},
          {"bounce", perSecond(statistics.bounceRays, seconds)},
          {"shadow", perSecond(statistics.shadowRays, seconds)}};
}

void addFigures(const Measurement& m, ordered_json& json) {
  const double seconds = median(m.traceSeconds);
  json["medianSeconds"] = seconds;
  json["spread"] = spread(m.traceSeconds);
  json["warmUpSeconds"] = m.warmUp.seconds;
  json["warmUpPasses"] = m.warmUp.passes;
  json["buildSeconds"] = median(m.buildSeconds);
  json["pipelineSeconds"] = m.pipelineSeconds;
  json["msamplesPerSecond"] = m.msamplesPerSecond();
  json["mraysPerSecond"] = m.mraysPerSecond();
  json["mraysPerSecondByKind"] = raysJson(m.statistics, seconds);
  json["stepsPerRay"] = m.stepsPerRay();
  json["dispatches"] = statistics::durationsJson(m.statistics.dispatchSeconds);
  json["deviceBytes"] = m.statistics.deviceBytes;
  json["structureQuality"] = m.statistics.structureQuality;
  if (!m.relMse) return;
  json["relMse"] = *m.relMse;
  json["efficiency"] = m.efficiency();
  if (!m.error) return;
  addInterval("relMse", m.error->relMse(), json);
  addInterval("errorAfterSecond", m.error->errorAfterSecond(), json);
}

const render::RenderStatistics& firstOf(const RenderRows& report) { return report.rows.front().measurement.statistics; }

}  // namespace

bool RenderRows::agree() const {
  return std::ranges::all_of(rows, [](const RenderRow& row) { return row.measurement.agrees; });
}

ordered_json toJson(const RenderRow& row) {
  const Measurement& m = row.measurement;
  ordered_json json;
  json["scene"] = row.scene;
  json["sceneHash"] = hashText(row.sceneHash);
  json["filmHash"] = hashText(m.filmHash);
  json["agrees"] = m.agrees;
  json["variant"] = m.variant.name;
  json["structure"] = nameOf(m.statistics.structure);
  json["bvhSplit"] = nameOf(m.statistics.bvhSplit);
  json["bvhQuality"] = nameOf(m.statistics.bvhQuality);
  json["size"] = extentText(m.variant.settings.image.size);
  json["samplesPerPixel"] = m.variant.settings.image.sampleCount;
  json["workgroup"] = extentText(m.statistics.workgroup);
  json["segmentsPerDispatch"] = m.statistics.maxSegmentsPerDispatch;
  json["kernel"] = nameOf(m.statistics.kernel);
  json["layout"] = nameOf(m.statistics.layout);
  json["sceneLoads"] = nameOf(m.statistics.sceneLoads);
  json["auto"] = m.statistics.automaticOrigin;
  if (m.agrees) addFigures(m, json);
  if (row.publishedSeconds) json["publishedSeconds"] = *row.publishedSeconds;
  return json;
}

ordered_json rowsJson(const RenderRows& report) {
  ordered_json rows = ordered_json::array();
  for (const RenderRow& row : report.rows) rows.push_back(toJson(row));
  return rows;
}

ordered_json reportJson(const std::string& schema, const std::string& device, const std::string& driver,
                        std::uint32_t repeats, bool agrees) {
  ordered_json json = reportHead(schema);
  json["device"] = device;
  json["driver"] = driver;
  json["repeats"] = repeats;
  json["agrees"] = agrees;
  return json;
}

ordered_json reportJson(const RenderRows& report) {
  const render::RenderStatistics& statistics = firstOf(report);
  return reportJson(kBenchSchema, statistics.device, statistics.driver, report.repeats, report.agree());
}

std::string headline(const render::RenderStatistics& statistics, std::uint32_t repeats,
                     std::span<const RenderRow> rows) {
  const std::string driver = statistics.driver.empty() ? "" : ", " + statistics.driver;
  WarmUpWork warmUp;
  std::size_t runs = 0;
  for (const RenderRow& row : rows) {
    warmUp.add(row.measurement.warmUp);
    runs += row.measurement.traceSeconds.size();
  }
  return fmt::format("candela {} on {}{}; {}", versionText(), statistics.device, driver,
                     repetitionText(repeats, warmUp, runs));
}

std::string headline(const RenderRows& report) { return headline(firstOf(report), report.repeats, report.rows); }

}  // namespace candela::bench

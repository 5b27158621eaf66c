#include "host/bench/structure_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "host/bench/text_table.h"
#include "host/core/hash_text.h"
#include "host/core/version.h"

namespace candela::bench {
namespace {

using nlohmann::ordered_json;

Variant variantOf(const char* name, RenderSettings settings, AccelKind accel, BvhSplit split) {
  settings.accel = accel;
  settings.bvhSplit = split;
  return {name, settings};
}

// What was in use rather than what was asked for: the reference has a tree of its own, and none for few primitives.
std::string structureText(const Measurement& m) {
  if (m.statistics.structure != "bvh") return m.statistics.structure == "grid" ? "uniform grid" : "none";
  return m.statistics.bvhSplit == "sah" ? "BVH, SAH" : "BVH, " + m.statistics.bvhSplit;
}

double structureBytes(const Measurement& measurement) {
  const auto& quality = measurement.statistics.structureQuality;
  const auto found = quality.find("bytes");
  return found == quality.end() ? 0 : found->second;
}

bool hasPublished(const StructureReport& report) {
  return std::any_of(report.rows.begin(), report.rows.end(), [](const StructureRow& row) { return row.publishedSeconds; });
}

std::vector<std::string> figures(const Measurement& m) {
  if (!m.agrees) return {"", "", "differs", "", "", "", ""};
  return {fmt::format("{:.2f}", 1e3 * median(m.buildSeconds)),
          fmt::format("{:.1f}", structureBytes(m) / 1024),
          fmt::format("{:.2f}", median(m.traceSeconds)),
          fmt::format("{:.0f} %", 100 * spread(m.traceSeconds)),
          fmt::format("{:.2f}", m.msamplesPerSecond()),
          fmt::format("{:.2f}", m.mraysPerSecond()),
          fmt::format("{:.1f}", m.stepsPerRay())};
}

TextTable tableOf(const StructureReport& report) {
  TextTable table;
  table.header = {"scene",  "structure",   "build ms", "KiB",         "trace s",
                  "spread", "Msamples/s", "Mrays/s",  "steps per ray"};
  const bool published = hasPublished(report);
  if (published) table.header.emplace_back("the report's s");
  for (const StructureRow& row : report.rows) {
    std::vector<std::string> cells{row.scene, structureText(row.measurement)};
    for (std::string& figure : figures(row.measurement)) cells.push_back(std::move(figure));
    if (published) cells.push_back(row.publishedSeconds ? fmt::format("{:.1f}", *row.publishedSeconds) : "");
    table.rows.push_back(std::move(cells));
  }
  return table;
}

std::string headline(const StructureReport& report) {
  const RenderStatistics& first = report.rows.front().measurement.statistics;
  const std::string driver = first.driver.empty() ? "" : ", " + first.driver;
  return fmt::format("candela {} on {}{}; median of {}, runs interleaved", versionText(), first.device, driver,
                     report.repeats);
}

ordered_json rowJson(const StructureRow& row) {
  const Measurement& m = row.measurement;
  ordered_json json;
  json["scene"] = row.scene;
  json["sceneHash"] = hashText(row.sceneHash);
  json["filmHash"] = hashText(m.filmHash);
  json["sameImage"] = m.agrees;
  json["variant"] = m.variant.name;
  json["structure"] = m.statistics.structure;
  json["bvhSplit"] = m.statistics.bvhSplit;
  json["size"] = extentText(m.variant.settings.size);
  json["samplesPerPixel"] = m.variant.settings.sampleCount;
  json["workgroup"] = extentText(m.statistics.workgroup);
  json["segmentsPerDispatch"] = m.statistics.maxSegmentsPerDispatch;
  json["kernel"] = m.statistics.kernel;
  json["layout"] = m.statistics.layout;
  json["sceneLoads"] = m.statistics.sceneLoads;
  if (m.agrees) {
    json["medianMs"] = 1e3 * median(m.traceSeconds);
    json["spread"] = spread(m.traceSeconds);
    json["buildMs"] = 1e3 * median(m.buildSeconds);
    json["msamplesPerSecond"] = m.msamplesPerSecond();
    json["mraysPerSecond"] = m.mraysPerSecond();
    json["stepsPerRay"] = m.stepsPerRay();
    json["structureQuality"] = m.statistics.structureQuality;
  }
  if (row.publishedSeconds) json["publishedSeconds"] = *row.publishedSeconds;
  return json;
}

}  // namespace

bool StructureReport::agree() const {
  return std::all_of(rows.begin(), rows.end(), [](const StructureRow& row) { return row.measurement.agrees; });
}

std::vector<Variant> structureVariants(const RenderSettings& settings) {
  return {variantOf("uniform grid", settings, AccelKind::grid, BvhSplit::sah),
          variantOf("BVH, midpoint", settings, AccelKind::bvh, BvhSplit::midpoint),
          variantOf("BVH, SAH", settings, AccelKind::bvh, BvhSplit::sah)};
}

std::string toText(const StructureReport& report) { return headline(report) + "\n\n" + toText(tableOf(report)); }

std::string toMarkdown(const StructureReport& report) {
  return headline(report) + "\n\n" + toMarkdown(tableOf(report));
}

ordered_json toJson(const StructureReport& report) {
  const RenderStatistics& first = report.rows.front().measurement.statistics;
  ordered_json json;
  json["schema"] = "candela-bench/1";
  json["version"] = versionText();
  json["device"] = first.device;
  json["driver"] = first.driver;
  json["repeats"] = report.repeats;
  for (const StructureRow& row : report.rows) json["rows"].push_back(rowJson(row));
  return json;
}

}  // namespace candela::bench

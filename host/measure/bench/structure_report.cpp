// Formats the comparison of acceleration structures.
#include "host/measure/bench/structure_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "host/base/statistics/quantiles.h"
#include "host/measure/bench/text_table.h"

namespace candela::bench {
namespace {

using nlohmann::ordered_json;
using statistics::median;
using statistics::spread;

Variant variantOf(const char* name, render::RenderSettings settings, render::AccelKind accel, render::BvhSplit split) {
  settings.structure.accel = accel;
  settings.structure.bvhSplit = split;
  return {name, settings};
}

// Returns the structure that was used, not the requested one: the reference has its own BVH, and none for few
// primitives, and devices trace few primitives as a list of records of one kind.
std::string structureText(const Measurement& m) {
  if (m.statistics.layout == render::LayoutInUse::list) return "list (too few primitives for a BVH)";
  if (m.statistics.structure == render::AccelKind::grid) return "uniform grid";
  if (m.statistics.structure == render::AccelKind::none) return "none";
  return m.statistics.bvhSplit == render::SplitInUse::sah ? "BVH, SAH"
                                                          : fmt::format("BVH, {}", nameOf(m.statistics.bvhSplit));
}

double structureBytes(const Measurement& measurement) {
  const auto& quality = measurement.statistics.structureQuality;
  const auto found = quality.find("bytes");
  return found == quality.end() ? 0 : found->second;
}

bool hasPublished(const StructureReport& report) {
  return std::any_of(report.rows.begin(), report.rows.end(), [](const RenderRow& row) { return row.publishedSeconds; });
}

std::vector<std::string> structureFigures(const Measurement& m) {
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
  table.header = {"scene",  "structure",  "build ms", "KiB",          "trace s",
                  "spread", "Msamples/s", "Mrays/s",  "steps per ray"};
  const bool published = hasPublished(report);
  if (published) table.header.emplace_back("published s");
  for (const RenderRow& row : report.rows) {
    std::vector<std::string> cells{row.scene, structureText(row.measurement)};
    for (std::string& figure : structureFigures(row.measurement)) cells.push_back(std::move(figure));
    if (published) cells.push_back(row.publishedSeconds ? fmt::format("{:.1f}", *row.publishedSeconds) : "");
    table.rows.push_back(std::move(cells));
  }
  return table;
}

}  // namespace

std::vector<Variant> structureVariants(const render::RenderSettings& settings) {
  return {variantOf("uniform grid", settings, render::AccelKind::grid, render::BvhSplit::sah),
          variantOf("BVH, midpoint", settings, render::AccelKind::bvh, render::BvhSplit::midpoint),
          variantOf("BVH, SAH", settings, render::AccelKind::bvh, render::BvhSplit::sah)};
}

std::string toText(const StructureReport& report) { return headline(report) + "\n\n" + toText(tableOf(report)); }

std::string toMarkdown(const StructureReport& report) {
  return headline(report) + "\n\n" + toMarkdown(tableOf(report));
}

ordered_json toJson(const StructureReport& report) {
  ordered_json json = reportJson(report);
  json["rows"] = rowsJson(report);
  return json;
}

}  // namespace candela::bench

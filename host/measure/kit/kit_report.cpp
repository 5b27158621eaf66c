// Formats the results of the kit.
#include "host/measure/kit/kit_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "host/judge/report/bar_chart.h"
#include "host/measure/bench/text_table.h"

namespace candela::kit {
namespace {

using bench::TextTable;

// The scenes of all results, in the order of their first appearance.
std::vector<std::string> scenesOf(const std::vector<KitResults>& results) {
  std::vector<std::string> scenes;
  for (const KitResults& one : results) {
    for (const RenderSpeed& row : fastestRenders(one)) {
      if (std::find(scenes.begin(), scenes.end(), row.scene) == scenes.end()) scenes.push_back(row.scene);
    }
  }
  return scenes;
}

const RenderSpeed* speedOf(const std::vector<RenderSpeed>& rows, const std::string& scene) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const RenderSpeed& row) { return row.scene == scene; });
  return found == rows.end() ? nullptr : &*found;
}

std::string conformanceText(const KitResults& results) {
  if (results.caseCounts.empty()) return "not run";
  std::vector<std::string> counts;
  for (const auto& [result, count] : results.caseCounts) counts.push_back(fmt::format("{} {}", count, result));
  return fmt::format("{}", fmt::join(counts, ", "));
}

std::string verifyText(const KitResults& results) {
  if (results.verdicts.empty()) return "not run";
  const auto agreeing = std::count_if(results.verdicts.begin(), results.verdicts.end(),
                                      [](const Verdict& verdict) { return verdict.agree; });
  return fmt::format("{} of {}", agreeing, results.verdicts.size());
}

// One row for each device: its outcome, and its maximum of samples per second in each scene.
TextTable deviceTable(const std::vector<KitResults>& results) {
  TextTable table{{"device", "driver", "conformance", "scenes that agree"}, {}};
  const std::vector<std::string> scenes = scenesOf(results);
  for (const std::string& scene : scenes) table.header.push_back(scene + " (Msamples/s)");
  for (const KitResults& one : results) {
    std::vector<std::string> cells{one.device, one.driver, conformanceText(one), verifyText(one)};
    const std::vector<RenderSpeed> fastest = fastestRenders(one);
    for (const std::string& scene : scenes) {
      const RenderSpeed* const speed = speedOf(fastest, scene);
      cells.push_back(speed == nullptr ? "" : fmt::format("{:.3g}", speed->msamplesPerSecond));
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

// The columns of the table in docs/drivers.md.
TextTable failureTable(const std::vector<KitResults>& results) {
  TextTable table{{"driver", "case", "result"}, {}};
  for (const KitResults& one : results) {
    for (const FailedCase& failed : one.failedCases)
      table.rows.push_back({one.driver, fmt::format("`{}`", failed.name), failed.result});
  }
  return table;
}

TextTable renderTable(const KitResults& results) {
  TextTable table{{"scene", "Msamples/s", "Mrays/s", "spread", "fastest variant"}, {}};
  for (const RenderSpeed& row : fastestRenders(results)) {
    table.rows.push_back({row.scene, fmt::format("{:.3g}", row.msamplesPerSecond),
                          fmt::format("{:.3g}", row.mraysPerSecond), fmt::format("{:.0f} %", 100 * row.spread),
                          row.variant});
  }
  return table;
}

TextTable rayTable(const KitResults& results) {
  TextTable table{{"scene", "rays", "Mrays/s", "fastest variant"}, {}};
  for (const RaySpeed& row : fastestRays(results))
    table.rows.push_back({row.scene, row.kind, fmt::format("{:.3g}", row.mraysPerSecond), row.variant});
  return table;
}

// The script runs each step under timeout(1), which has these exit codes for a step that it ends.
bool wasEnded(const Step& step) { return step.exitCode == 124 || step.exitCode == 137; }

std::string describe(const Step& step) {
  if (wasEnded(step)) return fmt::format("was not finished after {:.0f} s, its time limit", step.seconds);
  return fmt::format("ended with exit code {} after {:.0f} s", step.exitCode, step.seconds);
}

// Lists steps whose exit code is not 0, other than those that found a difference (3) or whose verdict is not decided
// (8), which the tables show.
std::string brokenSteps(const KitResults& results) {
  std::string lines;
  for (const Step& step : results.steps) {
    if (step.exitCode == 0 || step.exitCode == 3 || step.exitCode == 8) continue;
    lines += fmt::format("- The step `{}` {}.\n", step.name, describe(step));
  }
  return lines;
}

std::string verdictList(const KitResults& results) {
  std::string lines;
  for (const Verdict& verdict : results.verdicts) lines += fmt::format("- `{}`: {}\n", verdict.scene, verdict.text);
  return lines;
}

std::string pageOf(const KitResults& results) {
  std::string page = fmt::format("## {}\n\n", results.device);
  page += fmt::format("Driver: {}. Host: {}, {}. Candela {}{}.\n\n", results.driver, results.processor, results.system,
                      results.version, results.quick ? ", small images" : "");
  page += fmt::format("Conformance: {}.\n\n", conformanceText(results));
  page += brokenSteps(results) + verdictList(results) + "\n";
  if (!results.renders.empty()) page += toMarkdown(renderTable(results)) + "\n";
  if (!results.rays.empty()) page += toMarkdown(rayTable(results)) + "\n";
  if (!results.tuned.empty()) page += fmt::format("`candela tune` chooses: {}.\n", results.tuned);
  return page;
}

}  // namespace

std::string toText(const std::vector<KitResults>& results) {
  std::string text = toText(deviceTable(results));
  const TextTable failures = failureTable(results);
  if (!failures.rows.empty()) text += "\n" + toText(failures);
  return text;
}

std::string toMarkdown(const std::vector<KitResults>& results) {
  std::string page = "# Results of the Candela kit\n\n" + toMarkdown(deviceTable(results)) + "\n";
  const TextTable failures = failureTable(results);
  if (!failures.rows.empty()) page += "Conformance cases that did not pass:\n\n" + toMarkdown(failures) + "\n";
  for (const KitResults& one : results) page += pageOf(one);
  return page;
}

std::string toSvg(const std::vector<KitResults>& results) {
  std::vector<report::BarGroup> groups;
  for (const std::string& scene : scenesOf(results)) {
    report::BarGroup group{scene, {}};
    for (const KitResults& one : results) {
      const std::vector<RenderSpeed> fastest = fastestRenders(one);
      const RenderSpeed* const speed = speedOf(fastest, scene);
      if (speed != nullptr) group.bars.push_back({one.device, speed->msamplesPerSecond, 0, 0});
    }
    groups.push_back(std::move(group));
  }
  return report::barChart("Candela: samples per second, fastest variant of each device", "Msamples/s", groups);
}

}  // namespace candela::kit

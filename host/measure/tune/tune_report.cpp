// Formats the measurements and the result of tuning.
#include "host/measure/tune/tune_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "host/base/setting_words.h"
#include "host/base/statistics/quantiles.h"
#include "host/measure/bench/render_rows.h"
#include "host/measure/bench/text_table.h"

namespace candela::tune {
namespace {

using bench::RenderRow;
using bench::TextTable;
using nlohmann::ordered_json;

const std::vector<RenderRow>& firstScenes(const TuneReport& report) {
  return report.result.rounds.front().rows.front().scenes;
}

const render::RenderStatistics& statisticsOf(const TuneReport& report) {
  return firstScenes(report).front().measurement.statistics;
}

std::string sceneTitle(const RenderRow& row) {
  const render::RenderSettings& settings = row.measurement.variant.settings;
  return fmt::format("{}, {} x {} spp, ms", row.scene, extentText(settings.image.size), settings.image.sampleCount);
}

std::string milliseconds(const RenderRow& row) {
  return row.measurement.agrees ? fmt::format("{:.1f}", 1e3 * statistics::median(row.measurement.traceSeconds))
                                : "differs";
}

TextTable tableOf(const TuneReport& report) {
  TextTable table;
  table.header = {"candidate", "round"};
  for (const RenderRow& scene : firstScenes(report)) table.header.push_back(sceneTitle(scene));
  table.header.insert(table.header.end(), {"speedup", "noise"});
  for (const Round& round : report.result.rounds) {
    const Row& base = round.rows.front();
    for (const Row& row : round.rows) {
      std::vector<std::string> cells{nameOf(row.candidate), round.purpose};
      for (const RenderRow& scene : row.scenes) cells.push_back(milliseconds(scene));
      const double times = gain(base, row);
      cells.push_back(times > 0 ? fmt::format("{:.3f}", times) : "");
      cells.push_back(times > 0 && &row != &base ? fmt::format("{:.1f} %", 100 * noise(base, row)) : "");
      table.rows.push_back(std::move(cells));
    }
  }
  return table;
}

std::string headline(const TuneReport& report) {
  std::vector<RenderRow> all;
  for (const Round& round : report.result.rounds) {
    for (const Row& row : round.rows) all.insert(all.end(), row.scenes.begin(), row.scenes.end());
  }
  return bench::headline(statisticsOf(report), report.repeats, all);
}

std::string verdict(const TuneReport& report) {
  const SearchResult& result = report.result;
  if (!result.builtInAgrees) return "nothing is chosen: the image of the built-in choice differs from the others'";
  const std::string name = nameOf(result.chosen);
  if (result.chosen == builtIn())
    return fmt::format("chosen: {}, the built-in choice; no other is clearly faster", name);
  return fmt::format("chosen: {}, {:.2f} times as fast as the built-in {} (noise {:.1f} %)", name, result.chosenGain,
                     nameOf(builtIn()), 100 * result.chosenNoise);
}

std::string storage(const TuneReport& report) {
  return report.file ? fmt::format("stored in {}; {} ignores it", report.file->string(), settingWords("untuned"))
                     : "nothing is stored";
}

std::string conclusion(const TuneReport& report) {
  const char* const layout = report.result.tunesLayout
                                 ? ""
                                 : "layout: not tuned, since the scenes have too few primitives for a BVH\n";
  return layout + verdict(report) + "\n" + storage(report) + "\n";
}

ordered_json candidateJson(const Candidate& candidate) {
  ordered_json json;
  for (std::size_t i = 0; i < candidate.size(); ++i) {
    json[dimensionTable()[i].option] = dimensionTable()[i].values[candidate[i]].name;
  }
  return json;
}

ordered_json rowsJson(const SearchResult& result) {
  ordered_json rows = ordered_json::array();
  for (const Round& round : result.rounds) {
    for (const Row& row : round.rows) {
      ordered_json json{{"round", round.purpose}, {"choice", candidateJson(row.candidate)}, {"agrees", row.agrees()}};
      if (const double times = gain(round.rows.front(), row); times > 0) {
        json["speedup"] = times;
        json["noise"] = noise(round.rows.front(), row);
      }
      for (const RenderRow& scene : row.scenes) {
        json["scenes"].push_back(bench::toJson(scene));
      }
      rows.push_back(std::move(json));
    }
  }
  return rows;
}

}  // namespace

std::string toText(const TuneReport& report) {
  return headline(report) + "\n\n" + toText(tableOf(report)) + "\n" + conclusion(report);
}

std::string toMarkdown(const TuneReport& report) {
  return headline(report) + "\n\n" + toMarkdown(tableOf(report)) + "\n" + conclusion(report);
}

ordered_json toJson(const TuneReport& report) {
  const render::RenderStatistics& statistics = statisticsOf(report);
  ordered_json json = bench::reportJson("candela-tune-report/2", statistics.device, statistics.driver, report.repeats,
                                        report.agree());
  json["rows"] = rowsJson(report.result);
  json["builtIn"] = candidateJson(builtIn());
  json["chosen"] = report.result.builtInAgrees ? candidateJson(report.result.chosen) : ordered_json();
  json["speedup"] = report.result.chosenGain;
  json["noise"] = report.result.chosenNoise;
  json["file"] = report.file ? ordered_json(report.file->string()) : ordered_json();
  return json;
}

}  // namespace candela::tune

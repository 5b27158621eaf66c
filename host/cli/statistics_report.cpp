// Computes rates and percentiles, and formats the statistics.
#include "host/cli/statistics_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "host/bench/measure.h"
#include "host/cli/adaptive_report.h"
#include "host/cli/bad_samples.h"
#include "host/cli/option_table.h"
#include "host/core/counted.h"
#include "host/core/hash_text.h"
#include "host/core/report_head.h"
#include "host/scene/memory.h"

namespace candela::cli {
namespace {

using nlohmann::ordered_json;

constexpr std::array kPhases{"parse", "build",    "structure", "upload", "pipeline",
                             "trace", "readBack", "write",     "total"};

double ratio(double numerator, double denominator) { return denominator > 0 ? numerator / denominator : 0; }

// Converts "--max-depth" to "maxDepth".
std::string jsonKey(const std::string& optionName) {
  std::string key;
  bool raise = false;
  for (const char character : optionName.substr(2)) {
    if (character != '-') key += raise ? static_cast<char>(std::toupper(character)) : character;
    raise = character == '-';
  }
  return key;
}

ordered_json jsonValue(const Option& option, const Arguments& arguments) {
  const std::vector<std::string> values = option.show(arguments);
  if (option.isFlag()) return !values.empty();
  if (values.size() != 1) return values;
  const ordered_json number = ordered_json::parse(values[0], nullptr, false);
  return number.is_number() ? number : ordered_json(values[0]);
}

ordered_json settingsJson(const Arguments& arguments) {
  ordered_json settings;
  for (const Option& option : optionTable()) {
    if (option.group == OptionGroup::image || option.group == OptionGroup::sceneFile) {
      settings[jsonKey(option.name())] = jsonValue(option, arguments);
    }
  }
  return settings;
}

ordered_json secondsJson(const RenderReport& report) {
  ordered_json seconds;
  for (const char* phase : kPhases) seconds[phase] = 0.0;
  for (const auto& [phase, value] : report.result.statistics.seconds) seconds[phase] = value;
  seconds["parse"] = report.job.parseSeconds;
  seconds["write"] = report.writeSeconds;
  seconds["total"] = report.totalSeconds;
  return seconds;
}

ordered_json dispatchJson(std::vector<double> seconds) {
  std::sort(seconds.begin(), seconds.end());
  return {{"count", seconds.size()},
          {"median", bench::percentile(seconds, 0.5)},
          {"p99", bench::percentile(seconds, 0.99)},
          {"max", bench::percentile(seconds, 1)}};
}

ordered_json raysJson(const render::RenderStatistics& statistics) {
  ordered_json rays{{"camera", statistics.cameraRays}};
  if (statistics.treeRays) {
    rays["cameraHits"] = statistics.treeRays->cameraHits;
    rays["reflected"] = statistics.treeRays->reflected;
    rays["refracted"] = statistics.treeRays->refracted;
  }
  rays["bounce"] = statistics.bounceRays;
  rays["shadow"] = statistics.shadowRays;
  rays["total"] = statistics.rays();
  return rays;
}

// Appends the leaves of nested objects with names like "seconds.trace".
void appendRows(const ordered_json& object, const std::string& prefix, std::string& out) {
  for (const auto& [key, value] : object.items()) {
    if (value.is_object()) {
      appendRows(value, prefix + key + ".", out);
      continue;
    }
    const std::string shown = value.is_number_float() ? fmt::format("{:.5g}", value.get<double>())
                              : value.is_string()     ? value.get<std::string>()
                                                      : value.dump();
    out += fmt::format("{:<32} {}\n", prefix + key, shown);
  }
}

// Rays that graze the edge of a closed volume may enter it and miss its other side by rounding. Volumes that are not
// closed affect every ray through the gap.
constexpr double kMaxRoundingFaults = 1e-4;  ///< per sample

void reportVolumeFaults(const render::RenderStatistics& statistics, const Log& log) {
  const std::uint64_t faults = statistics.volumeFaults;
  if (faults == 0) return;
  const double fraction = ratio(static_cast<double>(faults), static_cast<double>(statistics.samples));
  if (fraction <= kMaxRoundingFaults) {
    log.detail(fmt::format("{} entered or left a volume on one side only, {:.2g} % of the samples: probably rounding",
                           counted(faults, "ray"), 100 * fraction));
    return;
  }
  log.warning(
      fmt::format("{} ({:.2g} % of the samples) hit volumes that are not closed or that overlap; absorption is "
                  "wrong there",
                  counted(faults, "ray"), 100 * fraction));
}

}  // namespace

ordered_json toJson(const RenderReport& report) {
  const render::RenderStatistics& statistics = report.result.statistics;
  const ordered_json seconds = secondsJson(report);
  const double traceSeconds = seconds["trace"];
  ordered_json json = reportHead("candela-render/1");
  json["scene"] = report.job.scene.name;
  json["sceneHash"] = hashText(report.job.scene.hash);
  json["filmHash"] = hashText(report.result.film.hash());
  json["settings"] = settingsJson(report.job.arguments);
  json["filmScale"] = report.result.film.scale();
  json["interrupted"] = report.result.interrupted;
  json["device"] = statistics.device;
  json["driver"] = statistics.driver;
  json["kernel"] = statistics.kernel;
  json["structure"] = render::structureName(statistics.structure);
  json["bvhSplit"] = statistics.bvhSplit;
  json["bvhQuality"] = statistics.bvhQuality;
  json["layout"] = statistics.layout;
  json["structureQuality"] = statistics.structureQuality;
  json["sceneLoads"] = statistics.sceneLoads;
  json["workgroup"] = extentText(statistics.workgroup);
  json["auto"] = statistics.automaticOrigin;
  json["tile"] = extentText(statistics.tile);
  json["segmentsPerDispatch"] = statistics.maxSegmentsPerDispatch;
  json["threads"] = statistics.threads;
  json["deviceBytes"] = statistics.deviceBytes;
  const scene::SceneMemory memory = scene::memoryOf(report.job.scene);
  json["sceneBytes"] = memory.total;
  json["bytesPerTriangle"] = memory.bytesPerTriangle().value_or(0);
  json["textureBytes"] = memory.textures;
  json["deepTextureBytes"] = memory.deepTextures;
  json["samples"] = statistics.samples;
  if (const auto plan = planOf(report.job.arguments)) {
    json["adaptive"] = adaptiveJson(*plan, report.result.film, report.job.settings().image.sampleCount);
  }
  json["rays"] = raysJson(statistics);
  json["traversalSteps"] = statistics.traversalSteps;
  json["verticesPerSample"] = ratio(static_cast<double>(statistics.vertices), static_cast<double>(statistics.samples));
  json["msamplesPerSecond"] = ratio(static_cast<double>(statistics.samples) / 1e6, traceSeconds);
  json["mraysPerSecond"] = ratio(static_cast<double>(statistics.rays()) / 1e6, traceSeconds);
  json["truncated"] = statistics.truncated;
  json["volumeFaults"] = statistics.volumeFaults;
  json["badSamples"] = statistics.badSamples;
  json["badPixels"] = report.badSamples.pixels();
  json["firstBadPixels"] = firstPixelsJson(report.badSamples, report.job);
  json["dispatch"] = dispatchJson(statistics.dispatchSeconds);
  json["seconds"] = seconds;
  if (report.work) json["work"] = film::toJson(*report.work);
  return json;
}

std::string toText(const RenderReport& report) {
  std::string out;
  appendRows(toJson(report), "", out);
  return out;
}

void reportFlaws(const RenderReport& report, const Log& log) {
  for (const std::string& line : badSampleLines(report.badSamples, report.job)) log.problem(line);
  reportVolumeFaults(report.result.statistics, log);
  if (const std::uint64_t count = badLayerCount(report.result.film); count > 0) {
    log.warning(
        fmt::format("layer values of {} are not finite or above 2^20; these were clamped", counted(count, "sample")));
  }
}

}  // namespace candela::cli

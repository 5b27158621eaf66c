// Computes rates and percentiles, and formats the statistics.
#include "host/app/cli/statistics_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "host/app/cli/adaptive_report.h"
#include "host/app/cli/bad_samples.h"
#include "host/app/cli/option_table.h"
#include "host/app/cli/settings_json.h"
#include "host/base/hash_text.h"
#include "host/base/json_text.h"
#include "host/base/report_head.h"
#include "host/base/statistics/quantiles.h"
#include "host/scene/memory.h"

namespace candela::cli {
namespace {

using nlohmann::ordered_json;
using statistics::ratio;

constexpr std::array kPhases{"parse", "build",    "structure", "upload", "pipeline",
                             "trace", "readBack", "write",     "total"};

ordered_json settingsJson(const Arguments& arguments) {
  ordered_json settings;
  for (const Option& option : optionTable()) {
    if (option.group == OptionGroup::image || option.group == OptionGroup::sceneFile) {
      settings[settingKey(option.name())] = settingValue(option, option.show(arguments));
    }
  }
  return settings;
}

ordered_json phaseSecondsJson(const RenderReport& report) {
  ordered_json seconds;
  for (const char* phase : kPhases) seconds[phase] = 0.0;
  for (const auto& [phase, value] : report.result.statistics.seconds) seconds[phase] = value;
  seconds["parse"] = report.job.parseSeconds;
  seconds["write"] = report.writeSeconds;
  seconds["total"] = report.totalSeconds;
  return seconds;
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

// Appends the leaves of nested objects with names like "phaseSeconds.trace".
void appendRows(const ordered_json& object, const std::string& prefix, std::string& out) {
  for (const auto& [key, value] : object.items()) {
    if (value.is_object()) {
      appendRows(value, prefix + key + ".", out);
      continue;
    }
    const std::string shown = value.is_number_float() ? fmt::format("{:.5g}", value.get<double>())
                              : value.is_string()     ? value.get<std::string>()
                                                      : jsonText(value);
    out += fmt::format("{:<32} {}\n", prefix + key, shown);
  }
}

}  // namespace

ordered_json toJson(const RenderReport& report) {
  const render::RenderStatistics& statistics = report.result.statistics;
  const ordered_json seconds = phaseSecondsJson(report);
  const double traceSeconds = seconds["trace"];
  ordered_json json = reportHead("candela-render/1");
  json["scene"] = report.job.scene().name;
  json["sceneHash"] = hashText(report.job.scene().hash);
  json["filmHash"] = hashText(report.result.film.hash());
  json["settings"] = settingsJson(statedArguments(report.job));
  json["filmScale"] = report.result.film.scale();
  json["interrupted"] = report.result.interrupted;
  json["device"] = statistics.device;
  json["driver"] = statistics.driver;
  json["kernel"] = nameOf(statistics.kernel);
  json["structure"] = nameOf(statistics.structure);
  json["bvhSplit"] = nameOf(statistics.bvhSplit);
  json["bvhQuality"] = nameOf(statistics.bvhQuality);
  json["layout"] = nameOf(statistics.layout);
  json["structureQuality"] = statistics.structureQuality;
  json["sceneLoads"] = nameOf(statistics.sceneLoads);
  json["workgroup"] = extentText(statistics.workgroup);
  json["auto"] = statistics.automaticOrigin;
  json["tile"] = extentText(statistics.tile);
  json["segmentsPerDispatch"] = statistics.maxSegmentsPerDispatch;
  json["threads"] = statistics.threads;
  json["deviceBytes"] = statistics.deviceBytes;
  json["memory"] = toJson(scene::memoryOf(report.job.scene()));
  json["samples"] = statistics.samples;
  if (const auto plan = job::planOf(report.job)) {
    json["adaptive"] = adaptiveJson(*plan, report.result.film, report.job.settings.image.sampleCount);
  }
  json["rays"] = raysJson(statistics);
  json["traversalSteps"] = statistics.traversalSteps;
  json["verticesPerSample"] = ratio(static_cast<double>(statistics.vertices), static_cast<double>(statistics.samples));
  json["msamplesPerSecond"] = ratio(static_cast<double>(statistics.samples) / 1e6, traceSeconds);
  json["mraysPerSecond"] = ratio(static_cast<double>(statistics.rays()) / 1e6, traceSeconds);
  json["truncated"] = statistics.truncated;
  json["volumeFaults"] = statistics.volumeFaults;
  json["badSamples"] = badSamplesJson(report.badSamples, report.job);
  json["dispatches"] = statistics::durationsJson(statistics.dispatchSeconds);
  json["phaseSeconds"] = seconds;
  if (report.work) json["work"] = film::reportJson(*report.work);
  return json;
}

std::string toText(const RenderReport& report) {
  std::string out;
  appendRows(toJson(report), "", out);
  return out;
}

}  // namespace candela::cli

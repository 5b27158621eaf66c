// `candela check`: describes scene files, or lists all of their errors.
#include <fmt/format.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "host/app/cli/commands.h"
#include "host/app/cli/json_output.h"
#include "host/app/cli/output_check.h"
#include "host/app/cli/separate_files.h"
#include "host/app/cli/text_output.h"
#include "host/base/counted.h"
#include "host/base/report_head.h"
#include "host/formats/load_scene.h"
#include "host/formats/scene_report.h"
#include "host/trace/flatten/light_table.h"
#include "host/trace/render/light_selection.h"

namespace candela::cli {
namespace {

using nlohmann::ordered_json;

ordered_json toJson(const scene::Diagnostic& diagnostic) {
  return {{"line", diagnostic.line}, {"column", diagnostic.column}, {"message", diagnostic.message}};
}

ordered_json errorsOf(const FileError& error) {
  ordered_json errors = ordered_json::array();
  if (const auto* sceneError = dynamic_cast<const scene::SceneError*>(&error)) {
    for (const scene::Diagnostic& diagnostic : sceneError->diagnostics) errors.push_back(toJson(diagnostic));
  } else {
    errors.push_back(toJson(scene::Diagnostic{"", 0, 0, error.what()}));
  }
  return errors;
}

// Warns of lights that are so weak beside the others that light sampling never chooses them by their power.
void warnOfUnsampledLights(const scene::Scene& scene, std::vector<std::string>& warnings) {
  const auto [emitters, others] = flatten::unsampledLights(flatten::buildLightTable(scene, true));
  if (emitters + others == 0) return;
  const bool byDefault = render::selectionFor(scene) == render::LightSelection::power;
  const std::string how = fmt::format("--lights power{} never samples",
                                      byDefault ? ", the default for this scene," : "");
  if (others > 0) {
    warnings.push_back(
        fmt::format("{} {} without extent, whose share of the power is less than 2^-24: their light is "
                    "missing",
                    how, counted(others, "light")));
  }
  if (emitters > 0) {
    warnings.push_back(
        fmt::format("{} {}, whose share of the power is less than 2^-24: only rays that happen to hit "
                    "them find their light, with more noise. --lights tree samples all emitters",
                    how, counted(emitters, "emitter")));
  }
}

// Returns one file's entry of the JSON report, and prints the text at once. Errors do not prevent the check of later
// files.
ordered_json checkFile(const std::string& file, const CheckArguments& arguments, const Log& log) {
  ordered_json entry{{"file", file}, {"valid", true}, {"errors", ordered_json::array()}};
  try {
    const scene::LoadedScene loaded = formats::loadScene(file, arguments.loadOptions);
    requireUnread(arguments, loaded.files);
    scene::SceneReport report = scene::makeReport(loaded);
    warnOfUnsampledLights(loaded.scene, report.warnings);
    if (wantsText(arguments, {arguments.json})) std::cout << scene::toText(report) << std::flush;
    entry["report"] = scene::toJson(report);
  } catch (const FileError& error) {
    log.problem(error.what());
    entry["valid"] = false;
    entry["errors"] = errorsOf(error);
  }
  return entry;
}

}  // namespace

ExitCode run(const CheckArguments& arguments, const Log& log) {
  requireWritableReport(arguments.json);
  ordered_json json = reportHead("candela-check/1");
  json["files"] = ordered_json::array();
  bool allValid = true;
  for (const std::string& file : arguments.files) {
    json["files"].push_back(checkFile(file, arguments, log));
    allValid = allValid && json["files"].back()["valid"].get<bool>();
  }
  writeJson(arguments.json, json);
  return allValid ? ExitCode::done : ExitCode::file;
}

}  // namespace candela::cli

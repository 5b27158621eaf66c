// `candela view`: a scene in a window.
#include <fmt/format.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "host/app/cli/commands.h"
#include "host/app/cli/json_output.h"
#include "host/app/cli/output_check.h"
#include "host/app/cli/viewed_scene.h"
#include "host/app/window/viewer.h"
#include "host/base/progress.h"
#include "host/base/report_head.h"
#include "host/base/statistics/quantiles.h"

namespace candela::cli {
namespace {

view::EngineHooks hooksOf(ViewedScene& scene) {
  view::EngineHooks hooks;
  hooks.load = [&scene](const view::Choice& choice, bool reads) { return scene.load(choice, reads); };
  hooks.addDevice = [&scene](const view::Choice& choice, view::Sessions& sessions) {
    scene.addDevice(choice, sessions);
  };
  hooks.save = [&scene](auto&&... what) { scene.save(what...); };
  return hooks;
}

std::vector<std::string> deviceNames() {
  std::vector<std::string> names;
  for (const vulkan::DeviceInfo& info : vulkan::listDevices()) names.push_back(info.name);
  return names;
}

nlohmann::ordered_json toJson(const window::ViewerReport& report) {
  nlohmann::ordered_json json = reportHead("candela-view/1");
  json["firstPictureSeconds"] = report.firstPicture;
  json["responses"] = statistics::durationsJson(report.responses);
  json["frames"] = report.frames;
  json["presentsFromDevice"] = report.presentsFromDevice;
  json["device"] = report.last.deviceName;
  json["deviceSamples"] = report.last.sides[0].samples;
  json["referenceSamples"] = report.last.sides[1].samples;
  return json;
}

}  // namespace

ExitCode run(const ViewArguments& arguments, const Log& log) {
  const double start = monotonicSeconds();
  requireWritableReport(arguments.json);
  ViewedScene scene(arguments, log);
  const view::Choice choice{arguments.device, arguments.request.image.integrator, arguments.layer,
                            arguments.loadOptions.time};
  const RenderJob first = scene.job(choice, true);
  image::DisplayTransform display;
  display.toneMap = arguments.toneMap.value_or(display.toneMap);
  display.exposure = arguments.exposure.value_or(0);
  const window::ViewerReport report = window::runViewer({.hooks = hooksOf(scene),
                                                         .choice = choice,
                                                         .devices = deviceNames(),
                                                         .scene = arguments.files.front(),
                                                         .size = first.settings.image.size,
                                                         .mode = arguments.mode,
                                                         .display = display,
                                                         .openDevice =
                                                             [&](const auto& extensions) {
                                                               view::Choice presented = choice;
                                                               if (choice.usesReference()) presented.device.clear();
                                                               return scene.open(presented, extensions);
                                                             },
                                                         .start = start});
  writeJson(arguments.json, toJson(report));
  return ExitCode::done;
}

}  // namespace candela::cli

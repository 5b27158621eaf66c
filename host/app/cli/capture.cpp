// `candela capture`: writes a program that repeats one dispatch without Candela.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iostream>

#include "host/app/cli/commands.h"
#include "host/app/cli/did_you_mean.h"
#include "host/app/cli/option_table.h"
#include "host/app/cli/render_job.h"
#include "host/app/cli/requirements.h"
#include "host/base/interrupt.h"
#include "host/drivers/capture/folder.h"
#include "host/drivers/capture/replay.h"
#include "host/drivers/capture/scene_capture.h"
#include "host/drivers/conformance/capture_case.h"
#include "host/drivers/conformance/case_tables.h"
#include "host/formats/loading/read_file.h"
#include "host/formats/nff/nff_loader.h"
#include "host/trace/vulkan/device_info.h"

namespace candela::cli {
namespace {

using capture::Capture;
using conformance::Case;
using conformance::Cases;

std::optional<vulkan::DeviceInfo> otherDevice(const CaptureArguments& arguments, const vulkan::DeviceInfo& device) {
  if (arguments.expect.empty()) return std::nullopt;
  const vulkan::DeviceInfo other = vulkan::selectDevice(arguments.expect);
  if (other.index != device.index) return other;
  throw UsageError(
      fmt::format("--expect {}: {} cannot be compared with itself; choose another device (see candela "
                  "devices)",
                  arguments.expect, device.name));
}

// Refuses options of renders for cases.
void refuseSceneOptions(const CaptureArguments& arguments) {
  for (const std::string& option : arguments.given) {
    static constexpr std::array kOfCases{"--output", "--expect", "--device", "--quiet", "--verbose"};
    if (std::ranges::find(kOfCases, option) != kOfCases.end()) continue;
    throw UsageError(fmt::format("{} does not apply to the case {}", option, arguments.files.front()));
  }
}

Capture captureOfCase(const Case& question, const CaptureArguments& arguments) {
  refuseSceneOptions(arguments);
  const vulkan::DeviceInfo device = vulkan::selectDevice(arguments.device);
  const std::optional<vulkan::DeviceInfo> other = otherDevice(arguments, device);
  Capture capture = conformance::captureCase(question, device);
  if (!other) return capture;
  expectBitsOf(capture, *other);
  check(capture, device);
  return capture;
}

// The text of NFF and P3F can be divided into statements; other scenes are divided into primitives.
std::unique_ptr<capture::SceneParts> partsOf(const RenderJob& job, const std::filesystem::path& file) {
  const std::string text = scene::readFile(file);
  if (!scene::nffLoader().recognises(text)) return capture::primitivesOf(job.scene());
  return capture::statementsOf(text, file.string(), scene::folderOrCurrent(file.parent_path()).string(), job.reading);
}

Capture captureOfScene(const CaptureArguments& arguments, const Log& log) {
  if (!arguments.pixel) {
    throw UsageError("--pixel X,Y is missing: `candela explain SCENE` names the pixel that differs most");
  }
  const RenderJob job = loadJob(arguments, log);
  capture::SceneRequest request{.settings = job.settings, .sample = sampleAskedFor(arguments, job.settings.image)};
  request.device.info = vulkan::selectDevice(arguments.device);
  if (const auto other = otherDevice(arguments, request.device.info)) request.expect = {*other};
  request.shrinkSeconds = arguments.shrinkSeconds;
  request.stop = &watchInterrupts();
  return captureScene(job.scene(), *partsOf(job, arguments.files.front()), request);
}

bool looksLikeCase(const std::string& word) {
  std::error_code ignored;
  return word.find('/') == std::string::npos && !std::filesystem::exists(word, ignored);
}

[[noreturn]] void refuseUnknown(const std::string& word, const Cases& cases) {
  std::vector<std::string> names;
  for (const Case& one : cases) names.push_back(one.name);
  throw UsageError(
      fmt::format("{}: there is no such scene file, and no case has this name{}; `candela conformance "
                  "--list` prints the names of cases",
                  word, didYouMean(word, names)));
}

Cases casesFor(const std::string& word) {
  return word.rfind("variants.", 0) == 0 ? conformance::variantCases() : conformance::allCases();
}

Capture captureOf(const CaptureArguments& arguments, const Log& log) {
  const std::string& word = arguments.files.front();
  const Cases cases = casesFor(word);
  const auto found = std::ranges::find(cases, word, &Case::name);
  if (found != cases.end()) return captureOfCase(*found, arguments);
  if (looksLikeCase(word)) refuseUnknown(word, cases);
  return captureOfScene(arguments, log);
}

void report(const Capture& capture, const CaptureArguments& arguments) {
  if (arguments.quiet) return;
  const std::string folder = shellQuoted(arguments.folder.string());
  std::cout << capture.title << "\n"
            << (capture.note.empty() ? "" : capture.note + "\n")
            << (capture.found.empty()
                    ? fmt::format("{} computes the expected values.\n", capture.capturedOn)
                    : fmt::format("{} computes other values: {}\n", capture.capturedOn, capture.found))
            << fmt::format("To repeat it: cd {} && cc -std=c99 -o reproduce reproduce.c -lvulkan && ./reproduce\n",
                           folder)
            << std::flush;
}

}  // namespace

ExitCode run(const CaptureArguments& arguments, const Log& log) {
  requireVulkanDevice(arguments, "the reference tracer does not run on a Vulkan driver");
  if (arguments.folder.empty()) throw UsageError("no output given: name a new folder with -o FOLDER");
  capture::requireNewFolder(arguments.folder);
  const std::atomic<bool>& interrupted = watchInterrupts();
  const Capture capture = captureOf(arguments, log);
  if (interrupted) throw InterruptedError("interrupted; nothing was written");
  capture::writeFolder(capture, arguments.folder);
  report(capture, arguments);
  return ExitCode::done;
}

}  // namespace candela::cli

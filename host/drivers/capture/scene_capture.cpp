// Shrinks the sample first, then the scene, then the sample again.
#include "host/drivers/capture/scene_capture.h"

#include <fmt/format.h>

#include <numeric>

#include "host/base/errors.h"
#include "host/base/stopwatch.h"
#include "host/drivers/capture/replay.h"
#include "host/drivers/capture/sample_values.h"
#include "host/drivers/capture/smallest_sample.h"

namespace candela::capture {
namespace {

void requireRunning(const SceneRequest& request) {
  if (request.stop != nullptr && *request.stop) throw InterruptedError("interrupted; nothing was written");
}

std::string regionText(const Sample& sample) {
  const render::Window window = sample.settings.image.window();
  const render::Extent group = sample.settings.execution.workgroupInUse();
  return fmt::format("{} x {} pixels from {},{} in workgroups of {} x {}, paths of at most {} rays", window.width,
                     window.height, window.x, window.y, group.width, group.height, sample.settings.image.maxDepth);
}

std::string titleOf(const scene::Scene& scene, const render::PixelSample& sample) {
  return fmt::format("{}, pixel {},{}, sample {}", scene.name, sample.x, sample.y, sample.index);
}

Subset allOf(const SceneParts& parts) {
  Subset all(parts.count());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

/// The parts and the sample that remain.
struct Remainder {
  Subset parts;
  Sample sample;
};

Remainder shrink(SampleTrial& trial, const scene::Scene& scene, const SceneParts& parts, const SceneRequest& request) {
  Remainder left{allOf(parts), smallestSample(trial, scene, request.settings, request.sample)};
  requireRunning(request);
  if (request.shrinkSeconds <= 0 || !trial.fails(scene, left.sample)) return left;
  Stopwatch watch;
  double passed = 0;
  left.parts = smallestScene(trial, parts, left.sample, [&] {
    passed += watch.lap();
    return passed > request.shrinkSeconds || (request.stop != nullptr && *request.stop);
  });
  requireRunning(request);
  return left;
}

}  // namespace

Capture captureScene(const scene::Scene& scene, const SceneParts& parts, const SceneRequest& request) {
  SampleTrial trial(request.device, request.expect);
  const Remainder left = shrink(trial, scene, parts, request);
  const bool isWhole = left.parts.size() == parts.count();
  const scene::Scene smaller = isWhole ? scene : parts.with(left.parts);
  Capture capture = trial.capture(smaller, left.sample);
  if (capture.expected.empty()) {
    throw UsageError(
        fmt::format("{}: single precision cannot decide this sample: choose another one, or a device whose "
                    "bits are expected",
                    titleOf(scene, request.sample)));
  }
  capture.title = titleOf(scene, request.sample);
  capture.expectedBy = request.expect ? fmt::format("{} ({})", request.expect->info.name, request.expect->info.driver)
                                      : "the reference tracer";
  capture.capturedOn = fmt::format("{} ({})", request.device.info.name, request.device.info.driver);
  capture.deviceName = request.device.info.name;
  capture.note = fmt::format("It renders {}, with {} of {} {} of the scene. The film is in binding {}.",
                             regionText(left.sample), left.parts.size(), parts.count(), parts.noun(), kFilmBinding);
  if (const std::string text = parts.textWith(left.parts); !text.empty()) capture.files.push_back({"scene.p3f", text});
  check(capture, request.device.info);
  requireRunning(request);
  return capture;
}

}  // namespace candela::capture

// Shrinks the sample first, then the scene, then the sample again.
#include "host/drivers/capture/scene_capture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>
#include <optional>

#include "host/base/errors.h"
#include "host/base/stopwatch.h"
#include "host/drivers/capture/replay.h"
#include "host/drivers/capture/sample_trial.h"
#include "host/drivers/capture/sample_values.h"
#include "host/drivers/capture/scene_parts.h"

namespace candela::capture {
namespace {

// Returns the pixels in the workgroup of this one, if the image is divided into workgroups from its corner on.
render::Window workgroupOf(const render::PixelSample& sample, const render::Extent& group, const render::Extent& size) {
  const std::uint32_t x = sample.x / group.width * group.width, y = sample.y / group.height * group.height;
  return {x, y, std::min(group.width, size.width - x), std::min(group.height, size.height - y)};
}

void takeFewestSegments(SampleTrial& trial, const scene::Scene& scene, Sample& sample) {
  Sample shorter = sample;
  for (std::uint32_t depth = 1; depth < sample.settings.image.maxDepth; ++depth) {
    shorter.settings.image.maxDepth = depth;
    if (!trial.fails(scene, shorter)) continue;
    sample = shorter;
    return;
  }
}

/// Returns the smallest workgroup, region and number of segments at which the sample of the pixel still fails: first
/// one pixel in a workgroup of one invocation, then one in the settings' workgroup, then all pixels of its workgroup.
/// If none fails, the first is returned.
Sample smallestSample(SampleTrial& trial, const scene::Scene& scene, const render::RenderSettings& settings,
                      const render::PixelSample& sample) {
  const render::Extent group = settings.execution.workgroupInUse();
  const render::Window pixel{sample.x, sample.y, 1, 1};
  struct Choice {
    render::Window window;
    render::Extent workgroup;
  };
  const std::array choices{Choice{pixel, {1, 1}}, Choice{pixel, group},
                           Choice{workgroupOf(sample, group, settings.image.size), group}};
  std::optional<Sample> first;
  for (const Choice& choice : choices) {
    Sample smaller{settings, sample.index};
    smaller.settings.image.crop = choice.window;
    smaller.settings.execution.workgroup = choice.workgroup;
    if (!first) first = smaller;
    if (!trial.fails(scene, smaller)) continue;
    takeFewestSegments(trial, scene, smaller);
    return smaller;
  }
  return *first;
}

/// Returns the parts of a scene without which the sample does not fail.
Subset smallestScene(SampleTrial& trial, const SceneParts& parts, const Sample& sample,
                     const std::function<bool()>& stop) {
  return smallestSubset(
      parts.count(),
      [&](const Subset& kept) {
        try {
          return trial.fails(parts.with(kept), sample);
        } catch (const Error&) {
          return false;
        }
      },
      stop);
}

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

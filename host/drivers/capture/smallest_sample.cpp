// Makes settings and scenes smaller as long as a sample fails.
#include "host/drivers/capture/smallest_sample.h"

#include <algorithm>
#include <array>
#include <optional>

#include "host/base/errors.h"

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

}  // namespace

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

}  // namespace candela::capture

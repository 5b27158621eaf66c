// Refuses devices and comparisons that make no sense.
#include "host/cli/requirements.h"

#include <fmt/format.h>

#include "host/core/errors.h"
#include "host/core/setting_words.h"
#include "host/explain/explanation.h"

namespace candela::cli {
namespace {

void requireTwoTracers(const Arguments& arguments) {
  requireVulkanDevice(arguments, "the reference tracer cannot be compared with itself");
}

}  // namespace

void requireVulkanDevice(const Arguments& arguments, const char* reason) {
  if (!arguments.usesReference()) return;
  throw UsageError(fmt::format("{}; choose a Vulkan device (see candela devices)", reason));
}

void requireVerifiable(const Arguments& arguments) {
  requireVulkanDevice(arguments, "the reference tracer cannot verify itself");
}

void requireComparable(const Arguments& arguments) {
  requireTwoTracers(arguments);
  if (arguments.request.image.integrator == render::Integrator::cost) {
    throw UsageError(
        "the integrator `cost` counts steps through acceleration structures, which the two tracers build differently, "
        "so "
        "that their counts cannot be compared; a render shows the counts of one");
  }
}

void requireExplainable(const Arguments& arguments) {
  requireTwoTracers(arguments);
  if (!arguments.pixel && arguments.given.contains("--sample")) {
    throw UsageError(fmt::format("{0} needs {1}; without {1}, sample 0 of the pixel that differs most is explained",
                                 settingWords("sample"), settingWords("pixel")));
  }
  explain::requirePaths(arguments.request.image.integrator);
}

render::PixelSample sampleAskedFor(const RenderJob& job) {
  const auto [x, y] = *job.arguments.pixel;
  const auto [width, height] = job.settings.image.size;
  if (x >= width || y >= height) {
    throw UsageError(fmt::format("the pixel {},{} is outside the image of {}x{} pixels (0,0 to {},{})", x, y, width,
                                 height, width - 1, height - 1));
  }
  if (job.arguments.sample >= job.settings.image.sampleCount) {
    throw UsageError(fmt::format("sample {} does not exist: a pixel has {} samples (0 to {}); use {} or more",
                                 job.arguments.sample, job.settings.image.sampleCount,
                                 job.settings.image.sampleCount - 1,
                                 settingWords("spp", fmt::to_string(job.arguments.sample + 1))));
  }
  return {x, y, job.arguments.sample};
}

}  // namespace candela::cli

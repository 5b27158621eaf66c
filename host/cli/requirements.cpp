// Refuses devices and comparisons that make no sense.
#include "host/cli/requirements.h"

#include <fmt/format.h>

#include "host/core/errors.h"
#include "host/explain/explanation.h"

namespace candela::cli {
namespace {

void requireTwoTracers(const Arguments& arguments) {
  requireVulkanDevice(arguments, "the reference tracer cannot be compared with itself");
}

}  // namespace

void requireVulkanDevice(const Arguments& arguments, const char* reason) {
  if (!arguments.usesReference()) return;
  throw UsageError(fmt::format("--device cpu: {}; choose a Vulkan device (see candela devices)", reason));
}

void requireVerifiable(const Arguments& arguments) {
  requireVulkanDevice(arguments, "the reference tracer cannot verify itself");
}

void requireComparable(const Arguments& arguments) {
  requireTwoTracers(arguments);
  if (arguments.request.image.integrator == render::Integrator::cost) {
    throw UsageError(
        "--integrator cost: the two tracers have different acceleration structures, so their counts cannot be "
        "compared; use `candela render` to see the counts of one");
  }
}

void requireExplainable(const Arguments& arguments) {
  requireTwoTracers(arguments);
  if (!arguments.pixel && arguments.given.contains("--sample")) {
    throw UsageError(
        "--sample needs --pixel X,Y; without --pixel, sample 0 of the pixel that differs most is explained");
  }
  explain::requirePaths(arguments.request.image.integrator);
}

render::PixelSample sampleAskedFor(const RenderJob& job) {
  const auto [x, y] = *job.arguments.pixel;
  const auto [width, height] = job.settings.image.size;
  if (x >= width || y >= height) {
    throw UsageError(fmt::format("--pixel {},{}: outside the image of {}x{} pixels (0,0 to {},{})", x, y, width, height,
                                 width - 1, height - 1));
  }
  if (job.arguments.sample >= job.settings.image.sampleCount) {
    throw UsageError(fmt::format("--sample {}: a pixel has {} samples (0 to {}); use --spp {} or more",
                                 job.arguments.sample, job.settings.image.sampleCount,
                                 job.settings.image.sampleCount - 1, job.arguments.sample + 1));
  }
  return {x, y, job.arguments.sample};
}

}  // namespace candela::cli

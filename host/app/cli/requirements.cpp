// Refuses devices and comparisons that make no sense.
#include "host/app/cli/requirements.h"

#include <fmt/format.h>

#include "host/base/errors.h"
#include "host/base/setting_words.h"
#include "host/judge/explain/explanation.h"

namespace candela::cli {
namespace {

void requireTwoTracers(const DeviceArguments& arguments) {
  requireVulkanDevice(arguments, "the reference tracer cannot be compared with itself");
}

}  // namespace

void requireVulkanDevice(const DeviceArguments& arguments, const char* reason) {
  if (!arguments.usesReference()) return;
  throw UsageError(fmt::format("{}; choose a Vulkan device (see candela devices)", reason));
}

void requireVerifiable(const VerifyArguments& arguments) {
  requireVulkanDevice(arguments, "the reference tracer cannot verify itself");
}

void requireComparable(const CompareArguments& arguments) {
  requireTwoTracers(arguments);
  if (arguments.request.image.integrator == render::Integrator::cost) {
    throw UsageError(
        "the integrator `cost` counts steps through acceleration structures, which the two tracers build differently, "
        "so "
        "that their counts cannot be compared; a render shows the counts of one");
  }
}

void requireExplainable(const ExplainArguments& arguments) {
  requireTwoTracers(arguments);
  if (!arguments.pixel && arguments.given.contains("--sample")) {
    throw UsageError(fmt::format("{0} needs {1}; without {1}, sample 0 of the pixel that differs most is explained",
                                 settingWords("sample"), settingWords("pixel")));
  }
  explain::requirePaths(arguments.request.image.integrator);
}

render::PixelSample sampleAskedFor(const SampleArguments& arguments, const render::ImageSettings& image) {
  const auto [x, y] = *arguments.pixel;
  const auto [width, height] = image.size;
  if (x >= width || y >= height) {
    throw UsageError(fmt::format("the pixel {},{} is outside the image of {}x{} pixels (0,0 to {},{})", x, y, width,
                                 height, width - 1, height - 1));
  }
  if (arguments.sample >= image.sampleCount) {
    throw UsageError(fmt::format("sample {} does not exist: a pixel has {} samples (0 to {}); use {} or more",
                                 arguments.sample, image.sampleCount, image.sampleCount - 1,
                                 settingWords("spp", fmt::to_string(arguments.sample + 1))));
  }
  return {x, y, arguments.sample};
}

}  // namespace candela::cli

// Renders until the mean is known precisely enough, and compares it with the exact one.
#include "host/verify/exact_test.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "host/core/stopwatch.h"
#include "host/statistics/error_rates.h"
#include "host/verify/agreement.h"
#include "host/verify/paired_sums.h"
#include "host/verify/time_limit.h"

namespace candela::verify {
namespace {

using statistics::Estimate;

// Looks of other tests have smaller indices, so that no seed is used twice.
constexpr std::uint32_t kFirstExactLook = kMaxPairedLooks;

double pValueAgainst(const Estimate& measured, double expected, double margin) {
  const Estimate exact{expected, 0, 1};
  return statistics::welch(measured, exact, margin + kRelativeTolerance * expected + kAbsoluteTolerance).pValue;
}

// The device's batches of the region, as many samples as `bias` (relative to `expected`) requires.
class DeviceMean {
 public:
  DeviceMean(const scene::Scene& scene, const render::RenderSettings& settings, render::Renderer& device,
             const Region& region)
      : region_{Region{0, 0, region.width, region.height}},
        batches_(Side::device, device, scene, cropped(settings, region), region_) {}

  // Returns false if `control` stopped it. The plan depends only on the standard error, never on the difference.
  bool render(double bias, double level, const std::optional<double>& timeLimit, const render::RenderControl& control) {
    TimeLimit limit(timeLimit);
    Stopwatch watch;
    batches_.prepare();
    limit.spend(watch.lap());
    std::uint64_t samples = 1;
    for (std::uint32_t look = 0; look < kMaxLooks; ++look) {
      const auto more = static_cast<std::uint32_t>(samples - batches_.samples());
      if (!batches_.render(more, kFirstExactLook + look, control)) return false;
      const Estimate mean = estimate();
      const double information = informationFraction(std::sqrt(mean.squaredError), bias,
                                                     statistics::criticalT(level, mean.degreesOfFreedom));
      if (information == 1 || look + 1 == kMaxLooks) break;
      const std::uint64_t wanted = nextSamples(batches_.samples(), information, kMaxLooks - 1 - look);
      samples = limit.affordable(watch.lap(), batches_.samples(), wanted);
      if (samples == batches_.samples()) break;
    }
    return true;
  }

  Estimate estimate() const { return statistics::estimateOf(statistics::summarise(batches_.means(0))); }
  const Batches& batches() const { return batches_; }

 private:
  static render::RenderSettings cropped(render::RenderSettings settings, const Region& region) {
    settings.image.crop = render::Window{region.x, region.y, region.width, region.height};
    return settings;
  }

  std::array<Region, 1> region_;  ///< in the film, which contains nothing else
  Batches batches_;
};

// The difference is that of the paired test: its uncertainty is that of the mean of a sample.
Estimate minus(const Estimate& device, const RegionResult& difference) {
  const double squaredError = difference.test.standardError * difference.test.standardError;
  return {device.mean - difference.test.difference, device.squaredError + squaredError, device.degreesOfFreedom};
}

}  // namespace

Region regionOf(const scene::ExactMean& exact, const render::Extent& image) {
  const auto first = [](float fraction, std::uint32_t size) {
    return std::min(static_cast<std::uint32_t>(std::floor(fraction * static_cast<float>(size))), size - 1);
  };
  const auto count = [](float fraction, std::uint32_t size) {
    return std::max(1u, static_cast<std::uint32_t>(std::lround(fraction * static_cast<float>(size))));
  };
  Region region{first(exact.area.x, image.width), first(exact.area.y, image.height), 0, 0, 0,
                Region::Quantity::luminance};
  region.width = std::min(count(exact.area.z, image.width), image.width - region.x);
  region.height = std::min(count(exact.area.w, image.height), image.height - region.y);
  return region;
}

std::optional<ExactTest> testExactMean(const scene::Scene& scene, const render::RenderSettings& settings,
                                       render::Renderer& device, const LightTestOptions& options,
                                       const LightTestResult& light, const render::RenderControl& control,
                                       render::BadSampleTally& badSamples) {
  ExactTest test;
  test.expected = image::luminance(glm::dvec3(scene.exactMean->rgb));
  test.level = statistics::sidakLevel(options.alpha, 2);
  Estimate deviceMean, referenceMean;
  double margin = 0;
  if (light.watchedDifference) {
    DeviceMean mean(scene, settings, device, *options.watched);
    const double bias = std::max(options.bias.value_or(0), kExactBias) * test.expected;
    if (!mean.render(bias, test.level, options.timeLimit, control)) return std::nullopt;
    badSamples.add(mean.batches().badSamples());
    test.samplesPerPixel = mean.batches().samples() * kBatchCount;
    deviceMean = mean.estimate();
    referenceMean = minus(deviceMean, *light.watchedDifference);
    margin = light.watchedDifference->margin;
  } else {
    deviceMean = statistics::estimateOf(light.watchedDevice);
    referenceMean = statistics::estimateOf(light.watchedReference);
  }
  test.device = deviceMean.mean;
  test.reference = referenceMean.mean;
  test.devicePValue = pValueAgainst(deviceMean, test.expected, 0);
  test.referencePValue = pValueAgainst(referenceMean, test.expected, margin);
  return test;
}

}  // namespace candela::verify

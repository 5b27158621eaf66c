// Renders until the mean is known precisely enough, and compares it with the exact one.
#include "host/judge/verify/exact_test.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "host/base/statistics/error_rates.h"
#include "host/base/stopwatch.h"
#include "host/judge/verify/agreement.h"
#include "host/judge/verify/paired_sums.h"
#include "host/judge/verify/time_limit.h"

namespace candela::verify {
namespace {

using statistics::Estimate;

// Looks of other tests have smaller indices, so that no seed is used twice.
constexpr std::uint32_t kFirstExactLook = kMaxPairedLooks;

// The mean of one side, and what is attributed to rounding in it.
struct SideMean {
  Estimate estimate;
  double margin = 0;

  double pValueAgainst(double expected) const {
    const Estimate exact{expected, 0, 1};
    return statistics::welch(estimate, exact, margin + kRelativeTolerance * expected + kAbsoluteTolerance).pValue;
  }

  // Returns the difference that would have been detected with probability kPower.
  double detectable(double level) const {
    if (estimate.squaredError == 0) return margin;
    const double critical = statistics::criticalT(level, estimate.degreesOfFreedom);
    return margin + (critical + statistics::normalQuantile(kPower)) * std::sqrt(estimate.squaredError);
  }
};

// One side's batches of the region, as many samples as `bias` (absolute) requires.
class OwnMean {
 public:
  OwnMean(Side side, const scene::Scene& scene, const render::RenderSettings& settings, render::Renderer& renderer,
          const Region& region)
      : region_{Region{0, 0, region.width, region.height}},
        batches_(side, renderer, scene, cropped(settings, region), region_) {}

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
      if (information == 1 || bias == 0 || look + 1 == kMaxLooks) break;
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
                                       render::Renderer& device, render::Renderer& reference,
                                       const LightTestOptions& options, const LightTestResult& light,
                                       const render::RenderControl& control, render::BadSampleTallies& badSamples) {
  ExactTest test;
  test.expected = image::luminance(glm::dvec3(scene.exactMean->rgb));
  test.level = statistics::sidakLevel(options.alpha, 2);
  const double bias = std::max(options.bias.value_or(0), kExactBias) * test.expected;
  const auto ownMean = [&](Side side, render::Renderer& renderer, render::BadSampleTally& bad, std::uint64_t& samples) {
    OwnMean own(side, scene, settings, renderer, *options.watched);
    if (!own.render(bias, test.level, options.timeLimit, control)) return std::optional<SideMean>();
    bad.add(own.batches().badSamples());
    samples = own.batches().samples() * kBatchCount;
    return std::optional(SideMean{own.estimate()});
  };
  std::optional<SideMean> ofDevice, ofReference;
  if (const std::optional<RegionResult>& difference = light.watchedDifference) {
    ofDevice = ownMean(Side::device, device, badSamples.device, test.samplesPerPixel);
    if (!ofDevice) return std::nullopt;
    const bool isControl = difference->excused <= kMaxControlMargin * test.expected;
    ofReference = isControl ? SideMean{minus(ofDevice->estimate, *difference), difference->excused}
                            : ownMean(Side::reference, reference, badSamples.reference, test.referenceSamplesPerPixel);
    if (!ofReference) return std::nullopt;
  } else {
    ofDevice = SideMean{statistics::estimateOf(light.watchedDevice)};
    ofReference = SideMean{statistics::estimateOf(light.watchedReference)};
  }
  test.device = ofDevice->estimate.mean;
  test.reference = ofReference->estimate.mean;
  test.devicePValue = ofDevice->pValueAgainst(test.expected);
  test.referencePValue = ofReference->pValueAgainst(test.expected);
  if (test.expected > 0) {
    test.detectableBias = std::max(ofDevice->detectable(test.level), ofReference->detectable(test.level)) /
                          test.expected;
  }
  return test;
}

}  // namespace candela::verify

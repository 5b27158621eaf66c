// Plans looks, renders batches on both sides with equal seeds, and tests their differences.
#include "host/judge/verify/paired_test.h"

#include <algorithm>
#include <cmath>

#include "host/base/divide_up.h"
#include "host/base/statistics/error_rates.h"
#include "host/base/stopwatch.h"
#include "host/judge/verify/paired_sums.h"
#include "host/judge/verify/time_limit.h"

namespace candela::verify {
namespace {

// A test of few values has no power, even if they are equal: small images are rendered in more batches.
constexpr std::uint64_t kMinValues = 65536;
constexpr std::uint64_t kMaxPairedSamples = std::uint64_t{1} << 24;  // per pixel

class PairedTest {
 public:
  PairedTest(const scene::Scene& scene, const render::RenderSettings& settings, render::Renderer& device,
             render::Renderer& reference, const LightTestOptions& options, double scale,
             const render::RenderControl& control)
      : scene_(scene),
        settings_(settings),
        deviceRenderer_(device),
        referenceRenderer_(reference),
        options_(options),
        control_(control),
        regions_(regionsOf(settings.image.size, options.watched)),
        testCount_(regions_.size() - (options.watched ? 1 : 0)),
        sums_(regions_, scale),
        level_(statistics::sidakLevel(options.alpha, testCount_)),
        batches_(batchesFor(settings.image.size)),
        samplesPerStep_(std::uint64_t{batches_} * minBatchSamples(settings.image.integrator)),
        defaultSamples_(defaultSamples(settings.image.size)),
        timeLimit_(options.timeLimit) {
    if (!options.keepFilms) return;
    result_.deviceFilm = render::emptyFilm(settings.image, settings.image.size);
    result_.referenceFilm = result_.deviceFilm;
  }

  LightTestResult run() {
    prepare();
    timeLimit_.spend(watch_.lap());
    std::uint64_t samples = samplesPerStep_;
    for (std::uint32_t look = 0; look < kMaxPairedLooks; ++look) {
      result_.interrupted = !renderTo(samples, look);
      if (result_.interrupted) break;
      takeLook(look);
      if (!options_.bias && samples_ >= maxSamples()) promiseWhatWasReached();
      if (result_.information == 1 || result_.differs() || isBeyondBias()) break;
      if (look + 1 == kMaxPairedLooks) break;
      samples = timeLimit_.affordable(watch_.lap(), samples_, wantedSamples(look), samplesPerStep_);
      result_.outOfTime = samples == samples_;
      if (result_.outOfTime) break;
    }
    result_.samplesPerPixel = samples_;
    return std::move(result_);
  }

 private:
  static std::uint32_t batchesFor(const render::Extent& size) {
    const std::uint64_t pixels = std::uint64_t{size.width} * size.height;
    return static_cast<std::uint32_t>(divideUp(kMinValues, pixels));
  }

  static std::uint64_t defaultSamples(const render::Extent& size) {
    const std::uint64_t pixels = std::uint64_t{size.width} * size.height;
    return std::clamp(kDefaultPaths / pixels, std::uint64_t{1}, kDefaultSamples);
  }

  // Without a requested bias, a run that noise would leave undecided goes on for longer.
  std::uint64_t maxSamples() const {
    if (options_.bias) return kMaxPairedSamples;
    return doubtOf(result_.image(), kMaxOverlooked) == Doubt::noise
               ? kPatience * std::max(defaultSamples_, samplesPerStep_)
               : defaultSamples_;
  }

  // The number of samples after the next look: `samples_` and a positive multiple of `samplesPerStep_`.
  std::uint64_t wantedSamples(std::uint32_t look) const {
    const std::uint32_t looksLeft = look + 1 < kMaxLooks ? kMaxLooks - 1 - look : 1;
    const std::uint64_t wanted = std::min(nextSamples(samples_, result_.information, looksLeft), maxSamples());
    return samples_ + divideUp(std::max(wanted, samples_ + 1) - samples_, samplesPerStep_) * samplesPerStep_;
  }

  void prepare() {
    device_ = deviceRenderer_.prepare(scene_, settings_);
    render::RenderSettings replicated = settings_;
    replicated.execution.replicas = 1;
    reference_ = referenceRenderer_.prepare(scene_, replicated);
  }

  // Every look has separate samples, because some samplers depend on the number of samples of a pixel.
  bool renderTo(std::uint64_t samples, std::uint32_t look) {
    render::ImageSettings image = settings_.image;
    image.sampleCount = static_cast<std::uint32_t>((samples - samples_) / batches_);
    for (std::uint32_t batch = 0; batch < batches_; ++batch) {
      image.seed = batchSeed(settings_.image.seed, Side::device, batch, look);
      device_->reset(image.seed, image.sampleCount);
      reference_->reset(image.seed, image.sampleCount);
      const render::SampleRange range{0, image.sampleCount};
      if (!device_->advance(range, control_) || !reference_->advance(range, control_)) return false;
      addBatch(image);
    }
    samples_ = samples;
    return true;
  }

  void addBatch(const render::ImageSettings& image) {
    result_.deviceStatistics = device_->statistics();
    render::requireComplete(result_.deviceStatistics);
    const image::Film deviceFilm = device_->film();
    const image::Film referenceFilm = reference_->film();
    sums_.add(deviceFilm, referenceFilm, deviationsOf(*reference_));
    result_.badSamples.device.add(deviceFilm, image);
    result_.badSamples.reference.add(referenceFilm, image);
    if (!options_.keepFilms) return;
    result_.deviceFilm.merge(deviceFilm);
    result_.referenceFilm.merge(referenceFilm);
  }

  // The p-values hold for all looks together, so that every look may use all of alpha.
  void takeLook(std::uint32_t look) {
    result_.regions.clear();
    for (std::size_t i = 0; i < testCount_; ++i) result_.regions.push_back(sums_.test(i, level_));
    if (options_.watched) result_.watchedDifference = sums_.test(testCount_, level_);
    result_.level = level_;
    result_.looks = look + 1;
    if (look == 0) result_.bias = options_.bias.value_or(defaultBias());
    result_.information = std::max(result_.information, sums_.information(0, result_.bias, level_));
  }

  double relativeMargin() const {
    const RegionResult& image = result_.image();
    return image.referenceMean == 0 ? 0 : image.relative(image.excused);
  }

  // No number of samples detects a bias that rounding excuses.
  bool isBeyondBias() const { return options_.bias && relativeMargin() >= *options_.bias; }

  // The detectable bias, beyond the margin, falls with the root of the number of samples. A verdict must detect
  // kMaxOverlooked, if rounding does not excuse it.
  double defaultBias() const {
    const double margin = relativeMargin();
    const double noise = result_.regions.front().detectableBias - margin;
    const double later = noise * std::sqrt(static_cast<double>(samples_) /
                                           static_cast<double>(std::max(defaultSamples_, samples_)));
    const double bias = std::max({kPairedBias, kMarginFactor * margin, margin + later});
    return margin < kMaxOverlooked ? std::min(bias, kMaxOverlooked) : bias;
  }

  // The first look may underestimate the noise of rare flips.
  void promiseWhatWasReached() {
    result_.bias = std::max(result_.bias, result_.regions.front().detectableBias);
    result_.information = 1;
  }

  const scene::Scene& scene_;
  render::RenderSettings settings_;
  render::Renderer& deviceRenderer_;
  render::Renderer& referenceRenderer_;
  std::unique_ptr<render::Session> device_, reference_;  ///< null before prepare()
  const LightTestOptions& options_;
  const render::RenderControl& control_;
  std::vector<Region> regions_;  ///< the tested regions, then the watched one
  std::size_t testCount_;
  PairedSums sums_;
  double level_;
  std::uint32_t batches_;
  std::uint64_t samplesPerStep_;  ///< per pixel: the smallest number in all batches
  std::uint64_t defaultSamples_;  ///< per pixel; every batch may add one
  std::uint64_t samples_ = 0;     ///< per pixel, so far
  TimeLimit timeLimit_;
  Stopwatch watch_;
  LightTestResult result_;
};

}  // namespace

LightTestResult testLightPaired(const scene::Scene& scene, const render::RenderSettings& settings,
                                render::Renderer& device, render::Renderer& reference, const LightTestOptions& options,
                                double scale, const render::RenderControl& control) {
  return PairedTest(scene, settings, device, reference, options, scale, control).run();
}

}  // namespace candela::verify

// The group-sequential test: plans looks, renders batches and tests regions.
#include "host/judge/verify/light_test.h"

#include <algorithm>
#include <cmath>

#include "host/base/statistics/error_rates.h"
#include "host/base/stopwatch.h"
#include "host/judge/verify/paired_sums.h"
#include "host/judge/verify/time_limit.h"

namespace candela::verify {
namespace {

using statistics::estimateOf;
using statistics::summarise;

constexpr std::uint32_t kFirstSamples = 1;                     // per pixel and batch
constexpr std::uint64_t kMaxSamples = std::uint64_t{1} << 24;  // per pixel and batch

class LightTest {
 public:
  LightTest(const scene::Scene& scene, const render::RenderSettings& settings, render::Renderer& device,
            render::Renderer& reference, const LightTestOptions& options, const render::RenderControl& control)
      : options_(options),
        control_(control),
        regions_(regionsOf(settings.image.size, options.watched)),
        testCount_(regions_.size() - (options.watched ? 1 : 0)),
        excuses_(regions_, 1),
        device_(Side::device, device, scene, settings, regions_),
        reference_(Side::reference, reference, scene, replicated(settings), regions_),
        timeLimit_(options.timeLimit) {
    result_.bias = options.bias.value_or(kIndependentBias);
    reference_.noteExcuses(excuses_);
    if (!options.keepFilms) return;
    device_.keepFilm();
    reference_.keepFilm();
  }

  LightTestResult run() {
    device_.prepare();
    reference_.prepare();
    timeLimit_.spend(watch_.lap());
    std::uint64_t samples = kFirstSamples;
    for (std::uint32_t look = 0; look < kMaxLooks; ++look) {
      if (!renderTo(samples, look)) return interrupted();
      takeLook(look);
      if (result_.information == 1 || result_.differs()) break;
      if (look + 1 == kMaxLooks) break;
      const std::uint64_t wanted = nextSamples(samples, result_.information, kMaxLooks - 1 - look);
      samples = timeLimit_.affordable(watch_.lap(), device_.samples(), std::min(wanted, kMaxSamples));
      result_.outOfTime = samples == device_.samples();
      if (result_.outOfTime) break;
    }
    return finished();
  }

 private:
  static render::RenderSettings replicated(render::RenderSettings settings) {
    settings.execution.replicas = 1;
    return settings;
  }

  bool renderTo(std::uint64_t samples, std::uint32_t look) {
    const auto more = static_cast<std::uint32_t>(samples - device_.samples());
    return device_.render(more, look, control_) && reference_.render(more, look, control_);
  }

  // The excuse is an estimate, too, whose error adds to that of the reference.
  RegionResult compareMeans(std::size_t region, double level) const {
    const RegionResult excuse = excuses_.test(region, level);
    statistics::Estimate reference = meanOf(reference_, region);
    reference.squaredError += excuse.test.standardError * excuse.test.standardError;
    RegionResult result = compareRegion(regions_[region], meanOf(device_, region), reference, level, excuse.excused);
    result.replicaDifference = excuse.replicaDifference;
    result.replicaStandardError = excuse.replicaStandardError;
    return result;
  }

  static statistics::Estimate meanOf(const Batches& batches, std::size_t region) {
    return estimateOf(summarise(batches.means(region)));
  }

  // The plan is for a test at the level of a single look, which is close to that of the last. It leaves out what is
  // excused, which more samples would not reduce.
  double informationNow() const {
    const double level = statistics::sidakLevel(options_.alpha, testCount_);
    const RegionResult image = compareRegion(regions_[0], meanOf(device_, 0), meanOf(reference_, 0), level);
    if (image.test.standardError == 0 || image.referenceMean == 0) return 1;
    return informationFraction(image.test.standardError, result_.bias * std::abs(image.referenceMean),
                               statistics::criticalT(level, image.test.degreesOfFreedom));
  }

  void takeLook(std::uint32_t look) {
    result_.information = std::max(result_.information, informationNow());
    const bool last = look + 1 == kMaxLooks;
    const double spent = statistics::spentAlpha(options_.alpha, last ? 1 : result_.information);
    if (spent > spent_) compareAll(statistics::sidakLevel(spent - spent_, testCount_));
    spent_ = std::max(spent_, spent);
    result_.looks = look + 1;
  }

  void compareAll(double level) {
    result_.level = level;
    result_.regions.clear();
    for (std::size_t i = 0; i < testCount_; ++i) {
      result_.regions.push_back(compareMeans(i, level));
    }
  }

  LightTestResult finished() {
    result_.samplesPerPixel = device_.samples() * kBatchCount;
    result_.badSamples = {device_.badSamples(), reference_.badSamples()};
    result_.deviceStatistics = device_.statistics();
    result_.deviceFilm = device_.takeFilm();
    result_.referenceFilm = reference_.takeFilm();
    if (options_.watched && result_.samplesPerPixel > 0) {
      result_.watchedDevice = summarise(device_.means(testCount_));
      result_.watchedReference = summarise(reference_.means(testCount_));
    }
    return std::move(result_);
  }

  LightTestResult interrupted() {
    result_.interrupted = true;
    return finished();
  }

  const LightTestOptions& options_;
  const render::RenderControl& control_;
  std::vector<Region> regions_;  ///< the tested regions, then the watched one
  std::size_t testCount_;
  PairedSums excuses_;  ///< of the reference against itself: only what rounding excuses
  Batches device_;
  Batches reference_;
  TimeLimit timeLimit_;
  Stopwatch watch_;
  double spent_ = 0;  ///< the part of alpha that has been spent
  LightTestResult result_;
};

}  // namespace

double informationFraction(double standardError, double bias, double criticalT) {
  if (standardError == 0) return 1;
  const double ratio = bias / ((criticalT + statistics::normalQuantile(kPower)) * standardError);
  return std::min(1.0, ratio * ratio);
}

std::uint64_t nextSamples(std::uint64_t samples, double information, std::uint32_t looksLeft) {
  constexpr double kReserve = 1.1;  // saves one look in most runs, for a tenth more samples
  const double needed = kReserve / information;
  const double evenly = std::pow(needed, 1.0 / looksLeft);
  const double growth = std::min(needed, std::max(2.0, evenly));
  return std::max(samples + 1, static_cast<std::uint64_t>(std::ceil(static_cast<double>(samples) * growth)));
}

LightTestResult testLight(const scene::Scene& scene, const render::RenderSettings& settings, render::Renderer& device,
                          render::Renderer& reference, const LightTestOptions& options,
                          const render::RenderControl& control) {
  return LightTest(scene, settings, device, reference, options, control).run();
}

}  // namespace candela::verify

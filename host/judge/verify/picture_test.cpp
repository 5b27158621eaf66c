// Tests the means of regions of renders against those of a picture with variances.
#include "host/judge/verify/picture_test.h"

#include <algorithm>
#include <cmath>

#include "host/base/statistics/error_rates.h"
#include "host/judge/verify/film_test.h"

namespace candela::verify {
namespace {

using statistics::Estimate;

std::vector<float> largerVariances(std::vector<float> a, const std::vector<float>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] = std::max(a[i], b[i]);
  return a;
}

class PictureTest {
 public:
  PictureTest(const RenderSet& a, const SamplesOfA& samples, const image::Image& picture, const SetTestOptions& options)
      : a_(a), picture_(picture), meanOfA_(a.mean()), bits_(std::min(a.significandBits(), picture.significandBits)) {
    meanOfA_.sampleCounts = samples.counts;
    variances_ = a.count() == 1 ? largerVariances(samples.variances, picture.luminanceVariance)
                                : picture.luminanceVariance;
    for (std::size_t i = 0; i < a.regions().size(); ++i) {
      if (a.regions()[i].quantity == Region::Quantity::luminance) indices_.push_back(i);
    }
    level_ = statistics::sidakLevel(options.alpha, indices_.size());
  }

  SetTestResult run(const SetTestOptions& options) const {
    SetTestResult result{{level_, {}, true}, options, a_.count(), 1, bits_, 1, 0, 0, false};
    result.options.design = SetDesign::picture;
    for (const std::size_t index : indices_) {
      RegionResult& region = result.regions.emplace_back(resultOf(index));
      region.test.pValue = statistics::sidakPValue(region.test.pValue, indices_.size());
      region.differs = region.test.pValue <= options.alpha;
      result.pValue = std::min(result.pValue, region.test.pValue);
    }
    return result;
  }

 private:
  // The less significant of the tests with either error of A.
  RegionResult resultOf(std::size_t index) const {
    const Region& region = a_.regions()[index];
    const Estimate b = estimateRegion(picture_, picture_.luminanceVariance, region);
    const double rounding = roundingOf(bits_) * std::abs(b.mean);
    const auto compared = [&](const Estimate& a) { return compareRegion(region, a, b, level_, rounding); };
    const RegionResult bySamples = compared(estimateRegion(meanOfA_, variances_, region));
    if (a_.count() == 1) return bySamples;
    const RegionResult byRenders = compared(amongRenders(index));
    RegionResult result = byRenders.test.pValue > bySamples.test.pValue ? byRenders : bySamples;
    result.detectableBias = std::max(byRenders.detectableBias, bySamples.detectableBias);
    return result;
  }

  Estimate amongRenders(std::size_t index) const {
    return statistics::estimateOf(statistics::summarise(statistics::column(a_.means(), index)));
  }

  const RenderSet& a_;
  const image::Image& picture_;
  image::Image meanOfA_;
  std::uint32_t bits_;
  std::vector<float> variances_;
  std::vector<std::size_t> indices_;  ///< of the regions that are tested
  double level_ = 0;
};

}  // namespace

SetTestResult testAgainstPicture(const RenderSet& a, const SamplesOfA& samples, const image::Image& picture,
                                 const SetTestOptions& options) {
  return PictureTest(a, samples, picture, options).run(options);
}

}  // namespace candela::verify

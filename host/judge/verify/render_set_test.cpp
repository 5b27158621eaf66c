// Tests the means of regions of two sets of renders.
#include "host/judge/verify/render_set_test.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/base/statistics/error_rates.h"
#include "host/judge/verify/agreement.h"

namespace candela::verify {
namespace {

using statistics::Rows;
using statistics::Summary;

Rows differencesOf(const Rows& a, const Rows& b) {
  Rows differences = a;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t region = 0; region < a[i].size(); ++region) differences[i][region] -= b[i][region];
  }
  return differences;
}

// Regions of one kind are consecutive: the image mean and its channels, and tiles of one size.
std::vector<std::size_t> familiesOf(const std::vector<Region>& regions) {
  std::vector<std::size_t> families;
  for (std::size_t i = 0; i < regions.size(); ++i) {
    if (i == 0 || regions[i].tileSize != regions[i - 1].tileSize) families.push_back(0);
    ++families.back();
  }
  return families;
}

// The error of this difference is unknown.
statistics::WelchTest untested(double difference) { return {difference, std::numeric_limits<double>::infinity(), 1}; }

// Welch's or Student's test of one region, for its standard error and its interval of confidence.
class RegionTest {
 public:
  RegionTest(const RenderSet& a, const RenderSet& b, const SetTestOptions& options)
      : a_(a), b_(b), rounding_(roundingOf(bits())) {
    if (options.design == SetDesign::paired) differences_ = differencesOf(a.means(), b.means());
  }

  std::uint32_t bits() const { return std::min(a_.significandBits(), b_.significandBits()); }

  // Differences that rounding may cause. Files round each pixel.
  double marginOf(std::size_t region) const {
    double sum = 0;
    for (const RenderSet* set : {&a_, &b_}) {
      for (const auto& row : set->means()) sum += row[region];
    }
    const double mean = sum / static_cast<double>(a_.count() + b_.count());
    return rounding_ * std::abs(mean) + kAbsoluteTolerance;
  }

  RegionResult resultOf(std::size_t region, double margin) const {
    const Summary a = statistics::summarise(statistics::column(a_.means(), region));
    const Summary b = statistics::summarise(statistics::column(b_.means(), region));
    const statistics::WelchTest test = differences_.empty() ? independentTest(a, b, margin)
                                                            : pairedTest(region, margin);
    return {a_.regions()[region], a.mean, b.mean, test, margin, margin};
  }

  // Returns those of each pair; empty for independent renders.
  const Rows& differences() const { return differences_; }

 private:
  statistics::WelchTest pairedTest(std::size_t region, double margin) const {
    const Summary summary = statistics::summarise(statistics::column(differences_, region));
    return summary.count < 2 ? untested(summary.mean) : statistics::welch(estimateOf(summary), {0, 0, 1}, margin);
  }

  // A single render has the variance of the other set.
  static statistics::WelchTest independentTest(const Summary& a, const Summary& b, double margin) {
    if (a.count + b.count < 3) return untested(a.mean - b.mean);
    const Summary& replicated = a.count > 1 ? a : b;
    const auto estimate = [&](const Summary& set) -> statistics::Estimate {
      if (set.count > 1) return estimateOf(set);
      return {set.mean, replicated.variance, static_cast<double>(replicated.count) - 1};
    };
    return statistics::welch(estimate(a), estimate(b), margin);
  }

  const RenderSet& a_;
  const RenderSet& b_;
  double rounding_;
  Rows differences_;
};

void judge(RegionResult& result, double pValue, double alpha, double criticalTail) {
  result.test.pValue = pValue;
  result.differs = pValue <= alpha;
  if (result.referenceMean == 0) return;
  double noise = 0;
  if (result.test.standardError > 0) {
    const double critical = criticalTail > 0 ? statistics::criticalT(criticalTail, result.test.degreesOfFreedom)
                                             : std::numeric_limits<double>::infinity();
    noise = statistics::detectableShift(critical, result.test.degreesOfFreedom, kPower) * result.test.standardError;
  }
  result.detectableBias = result.relative(result.margin + noise);
}

}  // namespace

RelativeDifference relativeDifferenceOf(const RegionResult& result) {
  double halfWidth = 0;
  if (result.test.standardError > 0) {
    halfWidth = statistics::criticalT(0.05, result.test.degreesOfFreedom) * result.test.standardError;
  }
  return {result.relative(result.test.difference), result.relative(result.test.difference - halfWidth),
          result.relative(result.test.difference + halfWidth)};
}

SetTestResult testRenderSets(const RenderSet& a, const RenderSet& b, const SetTestOptions& options) {
  const RegionTest tests(a, b, options);
  statistics::PermutationPlan plan{{}, familiesOf(a.regions()), options.alpha, 0, options.threads};
  for (std::size_t region = 0; region < a.regions().size(); ++region) plan.margins.push_back(tests.marginOf(region));
  const statistics::PermutationTest permutation = options.design == SetDesign::paired
                                                      ? statistics::testPairs(tests.differences(), plan)
                                                      : statistics::testGroups(a.means(), b.means(), plan);

  SetTestResult result{{statistics::sidakLevel(options.alpha, a.regions().size()), {}, true},
                       options,
                       a.count(),
                       b.count(),
                       tests.bits(),
                       permutation.pValue,
                       permutation.minPValue,
                       permutation.divisions,
                       permutation.isExhaustive,
                       options.design == SetDesign::paired && a.means() == b.means()};
  std::size_t region = 0;
  for (std::size_t family = 0; family < plan.families.size(); ++family) {
    for (std::size_t i = 0; i < plan.families[family]; ++i, ++region) {
      RegionResult one = tests.resultOf(region, plan.margins[region]);
      judge(one, permutation.pValues[region], options.alpha, permutation.criticalTails[family]);
      result.regions.push_back(one);
    }
  }
  return result;
}

double roundingOf(std::uint32_t significandBits) {
  return std::max(kRelativeTolerance, std::exp2(-double{1} * significandBits));
}

std::size_t minRenders(SetDesign design, double alpha) {
  std::size_t count = 1;
  double pValue = 1;  // 2 / 2^n, or 2 / (2n over n)
  while (pValue > alpha) {
    const auto n = static_cast<double>(++count);
    pValue *= design == SetDesign::paired ? 0.5 : n / (2 * (2 * n - 1));
  }
  return count;
}

Conclusion SetTestResult::conclusion() const {
  if (differs()) return Conclusion::different;
  return doubt() == Doubt::none ? Conclusion::same : Conclusion::undecided;
}

Doubt SetTestResult::doubt() const {
  if (differs() || hasEqualPairs) return Doubt::none;
  if (minPValue > options.alpha) return Doubt::renders;
  return doubtOf(image(), options.maxOverlooked);
}

}  // namespace candela::verify

// Adds up differences, and tests them.
#include "host/judge/verify/paired_sums.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace candela::verify {
namespace {

// The index of a quantity in a Deviation.
int componentOf(Region::Quantity quantity) {
  return quantity == Region::Quantity::luminance ? 3 : static_cast<int>(quantity) - 1;
}

double variationOf(const statistics::SelfNormalisedSum& values) {
  if (values.count == 0) return 0;
  return std::max(0.0, values.squares - values.sum * values.sum / static_cast<double>(values.count));
}

// The more uncertain side.
double variationOf(const PairedSum& sum) { return std::max(variationOf(sum.brighter), variationOf(sum.darker)); }

// The largest sum of differences that is attributed to rounding. A drift of replicas is one only beyond its noise.
double excusedSum(const PairedSum& sum) {
  return sum.margin + std::max(0.0, std::abs(sum.drift) - kDriftErrors * std::sqrt(variationOf(sum)));
}

}  // namespace

std::vector<render::Deviation> deviationsOf(render::Session& session) {
  render::ReplicaSource* const source = session.replicaSource();
  return source != nullptr ? source->replicas().deviations : std::vector<render::Deviation>{};
}

PairedSums::PairedSums(std::span<const Region> regions, double scale)
    : regions_(regions), scale_(scale > 0 ? scale : 1), sums_(regions.size()) {}

void PairedSums::add(const image::Film& device, const image::Film& reference,
                     std::span<const render::Deviation> deviations) {
  const double quantum = filmQuantum(device);
  for (std::size_t i = 0; i < regions_.size(); ++i) {
    const Region& region = regions_[i];
    const int component = componentOf(region.quantity);
    for (std::uint32_t y = region.y; y < region.y + region.height; ++y) {
      for (std::uint32_t x = region.x; x < region.x + region.width; ++x) {
        const std::size_t pixel = std::size_t{y} * device.width() + x;
        const double count = device.at(x, y).sampleCount;
        const double a = count * quantityOf(device.mean(x, y), region.quantity);
        const double b = count * quantityOf(reference.mean(x, y), region.quantity);
        const render::Deviation deviation = deviations.empty() ? render::Deviation{} : deviations[pixel];
        const double margin = kOneWay * deviation.magnitude[component] + count * quantum;
        const double difference = a - b - deviation.drift[component];
        PairedSum& sum = sums_[i];
        sum.brighter.add(difference - margin);
        sum.darker.add(-difference - margin);
        sum.device += a;
        sum.reference += b;
        sum.margin += margin;
        sum.drift += deviation.drift[component];
        sum.replica.add(deviation.lean[component] + deviation.drift[component]);
        sum.samples += count;
      }
    }
  }
}

RegionResult PairedSums::test(std::size_t region, double level) const {
  const PairedSum& sum = sums_[region];
  RegionResult result;
  result.region = regions_[region];
  result.deviceMean = sum.device / sum.samples;
  result.referenceMean = sum.reference / sum.samples;
  const statistics::SelfNormalisedSum& larger = sum.brighter.sum > sum.darker.sum ? sum.brighter : sum.darker;
  result.margin = sum.margin / sum.samples;
  result.test.difference = (sum.device - sum.reference) / sum.samples;
  result.test.standardError = std::sqrt(variationOf(sum)) / sum.samples;
  result.test.degreesOfFreedom = static_cast<double>(larger.count) - 1;
  result.test.t = larger.sum > 0 ? larger.sum / std::sqrt(larger.squares) : 0;
  result.test.pValue = std::min(1.0, 2 * statistics::pValueOf(larger, scale_));
  result.differs = result.test.pValue < level;
  result.excused = excusedSum(sum) / sum.samples;
  result.replicaDifference = sum.replica.sum / sum.samples;
  result.replicaStandardError = std::sqrt(variationOf(sum.replica)) / sum.samples;
  if (sum.reference != 0) {
    result.detectableBias = (neededSum(sum, level) + excusedSum(sum)) / std::abs(sum.reference);
  }
  return result;
}

// Differences that are all equal are found however small they are, unless they are too few.
double PairedSums::neededSumOfEqualValues(std::uint64_t count, double level) const {
  const auto values = static_cast<double>(count);
  const statistics::SelfNormalisedSum ofScale{values * scale_, values * scale_ * scale_, count};
  return statistics::pValueOf(ofScale, scale_) < level / 2 ? 0 : std::numeric_limits<double>::infinity();
}

double PairedSums::neededSum(const PairedSum& sum, double level) const {
  const double variation = variationOf(sum);
  if (variation == 0) return neededSumOfEqualValues(sum.brighter.count, level);
  const auto count = static_cast<double>(sum.brighter.count);
  double needed = 0;
  // A bias adds to the squares, too.
  for (int i = 0; i < 30; ++i) {
    const double critical = statistics::criticalSum(variation + needed * needed / count, scale_, level / 2);
    needed = critical + statistics::normalQuantile(kPower) * std::sqrt(variation);
  }
  return needed;
}

double PairedSums::information(std::size_t region, double bias, double level) const {
  const PairedSum& sum = sums_[region];
  const double excess = bias * std::abs(sum.reference) - excusedSum(sum);
  if (excess <= 0) return sum.reference == 0 ? 1 : 0;
  const double ratio = excess / neededSum(sum, level);
  return std::min(1.0, ratio * ratio);
}

}  // namespace candela::verify

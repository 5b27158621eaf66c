// Counts values and differences in bins.
#include "host/judge/report/histogram.h"

#include <algorithm>
#include <cmath>

#include "host/image/metrics.h"

namespace candela::report {
namespace {

constexpr int kMaxStops = 24;
constexpr std::size_t kBinsPerStop = 2;
constexpr std::size_t kDifferenceBins = 41;  // odd, so that equal pixels are in the middle bin
constexpr double kFractionWithin = 0.99;

struct StopRange {
  double low = -1;
  double high = 0;
};

// Rounds to whole stops.
StopRange stopRange(const image::Image& a, const image::Image& b) {
  double minStops = HUGE_VAL;
  double maxStops = -HUGE_VAL;
  for (const image::Image* image : {&a, &b}) {
    for (const glm::vec3& pixel : image->rgb) {
      const double stops = std::log2(image::luminance(glm::dvec3(pixel)));
      if (!std::isfinite(stops)) continue;
      minStops = std::min(minStops, stops);
      maxStops = std::max(maxStops, stops);
    }
  }
  if (minStops > maxStops) return {};
  const double high = std::floor(maxStops) + 1;
  return {std::max(std::floor(minStops), high - kMaxStops), high};
}

Histogram histogramOfStops(const image::Image& image, const StopRange& range) {
  Histogram histogram(range.low, range.high, static_cast<std::size_t>(range.high - range.low) * kBinsPerStop);
  for (const glm::vec3& pixel : image.rgb) histogram.add(std::log2(image::luminance(glm::dvec3(pixel))));
  return histogram;
}

std::vector<double> relativeDifferences(const image::Image& a, const image::Image& b) {
  const double scale = differenceScale(a, b);
  std::vector<double> differences;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) {
    const double expected = image::luminance(glm::dvec3(b.rgb[i]));
    differences.push_back((image::luminance(glm::dvec3(a.rgb[i])) - expected) / (expected + scale));
  }
  return differences;
}

double rangeOf(const std::vector<double>& differences) {
  const auto wanted = kFractionWithin * static_cast<double>(differences.size());
  for (const double range : {0.001, 0.01, 0.1, 1.0}) {
    const auto within = std::count_if(differences.begin(), differences.end(),
                                      [=](double d) { return std::abs(d) <= range; });
    if (static_cast<double>(within) >= wanted) return range;
  }
  return 10;
}

}  // namespace

void Histogram::add(double value) {
  if (!std::isfinite(value)) {
    ++leftOut;
    return;
  }
  const double position = (value - low) / (high - low) * static_cast<double>(counts.size());
  const double last = static_cast<double>(counts.size() - 1);
  ++counts[static_cast<std::size_t>(std::clamp(std::floor(position), 0.0, last))];
}

ValueHistograms valueHistograms(const image::Image& a, const image::Image& b) {
  const StopRange range = stopRange(a, b);
  return {histogramOfStops(a, range), histogramOfStops(b, range)};
}

Histogram differenceHistogram(const image::Image& a, const image::Image& b) {
  const std::vector<double> differences = relativeDifferences(a, b);
  const double range = rangeOf(differences);
  Histogram histogram(-range, range, kDifferenceBins);
  for (const double difference : differences) histogram.add(difference);
  return histogram;
}

}  // namespace candela::report

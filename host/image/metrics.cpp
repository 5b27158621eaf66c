// Compares two images pixel by pixel and channel by channel.
#include "host/image/metrics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/base/errors.h"
#include "host/base/finite.h"
#include "host/image/colour_map.h"

namespace candela::image {
namespace {

using glm::dvec3;

constexpr double kRelativeEpsilon = 0.01;

void requireEqualSizes(const Image& a, const Image& reference) {
  if (a.width == reference.width && a.height == reference.height) return;
  throw UsageError(fmt::format("images of different sizes cannot be compared: {} x {} and {} x {} pixels", a.width,
                               a.height, reference.width, reference.height));
}

double sumOf(const dvec3& v) { return v.x + v.y + v.z; }

bool differs(const dvec3& difference, const dvec3& reference, const DifferenceTolerance& tolerance) {
  const dvec3 allowed = glm::max(dvec3(tolerance.absolute), tolerance.relative * glm::abs(reference));
  return glm::any(glm::greaterThan(difference, allowed));
}

double relativeDifference(double value, double reference) {
  if (value == reference) return 0;
  return (value - reference) / reference;
}

/// Sums over pixels, in double precision and row by row.
struct Sums {
  std::uint64_t pixelCount = 0;
  dvec3 a{0};
  dvec3 reference{0};
  double squared = 0;
  double relativeSquared = 0;
  double clampedSquared = 0;

  void add(const dvec3& value, const dvec3& expected) {
    const dvec3 difference = value - expected;
    const dvec3 clamped = glm::clamp(value, 0.0, 1.0) - glm::clamp(expected, 0.0, 1.0);
    ++pixelCount;
    a += value;
    reference += expected;
    squared += sumOf(difference * difference);
    relativeSquared += sumOf(difference * difference / (expected * expected + kRelativeEpsilon));
    clampedSquared += sumOf(clamped * clamped);
  }
};

void setMeans(ImageComparison& result, const Sums& sums) {
  if (sums.pixelCount == 0) return;
  const auto pixelCount = static_cast<double>(sums.pixelCount);
  const double valueCount = 3 * pixelCount;
  result.mean = sums.a / pixelCount;
  result.referenceMean = sums.reference / pixelCount;
  result.meanLuminance = luminance(result.mean);
  result.referenceMeanLuminance = luminance(result.referenceMean);
  result.relativeMeanDifference = relativeDifference(result.meanLuminance, result.referenceMeanLuminance);
  result.meanSquaredError = sums.squared / valueCount;
  result.relativeMeanSquaredError = sums.relativeSquared / valueCount;
  result.peakSignalToNoise = 10 * std::log10(valueCount / sums.clampedSquared);
  result.differingFraction = static_cast<double>(result.differingCount) / pixelCount;
}

}  // namespace

ImageComparison compareImages(const Image& a, const Image& reference, const DifferenceTolerance& tolerance) {
  requireEqualSizes(a, reference);
  ImageComparison result;
  result.width = a.width;
  result.height = a.height;
  result.tolerance = tolerance;
  result.maximumX = a.origin.x, result.maximumY = a.origin.y;
  Sums sums;
  for (std::uint32_t y = 0; y < a.height; ++y) {
    for (std::uint32_t x = 0; x < a.width; ++x) {
      const dvec3 value(a.at(x, y));
      const dvec3 expected(reference.at(x, y));
      if (!isFinite(value) || !isFinite(expected)) {
        ++result.notFiniteCount;
        continue;
      }
      sums.add(value, expected);
      const dvec3 difference = glm::abs(value - expected);
      const double largest = std::max({difference.x, difference.y, difference.z});
      if (largest > result.maximumDifference) {
        result.maximumDifference = largest;
        result.maximumX = a.origin.x + x;
        result.maximumY = a.origin.y + y;
      }
      if (differs(difference, expected, tolerance)) ++result.differingCount;
    }
  }
  setMeans(result, sums);
  return result;
}

double differenceScale(const Image& a, const Image& reference) {
  return std::max(0.01 * compareImages(a, reference).referenceMeanLuminance, 1e-30);
}

Image differencePicture(const Image& a, const Image& reference, double range) {
  requireEqualSizes(a, reference);
  if (!(range > 0)) throw UsageError("the range of a difference picture must be positive");
  constexpr dvec3 kNotFinite(1, 0, 1);
  const double scale = differenceScale(a, reference);

  Pixels8 picture{a.width, a.height, {}};
  picture.rgb.reserve(3 * a.rgb.size());
  for (std::size_t i = 0; i < a.rgb.size(); ++i) {
    const double expected = luminance(dvec3(reference.rgb[i]));
    const double difference = (luminance(dvec3(a.rgb[i])) - expected) / (expected + scale);
    const double strength = std::clamp(difference / range, -1.0, 1.0);
    const dvec3 signal = std::isfinite(difference) ? signedColour(strength) : kNotFinite;
    for (int c = 0; c < 3; ++c) picture.rgb.push_back(static_cast<std::uint8_t>(std::lround(255 * signal[c])));
  }
  return toImage(picture);
}

}  // namespace candela::image

// How alike two pixels are: the weights of docs/denoising.md, section 3, in double precision.
#pragma once
#include <algorithm>
#include <glm/glm.hpp>

#include "shaders/shared/denoise_data.h"

namespace candela::denoise {

/// The square of Welch's statistic before the division.
struct WelchStatistic {
  double squaredDifference = 0, variance = 0;

  double quotient() const { return squaredDifference / variance; }
};

/// Compares two means of vectors, whose variances are in `w`, all channels together.
inline WelchStatistic compareMeans(const glm::dvec4& a, const glm::dvec4& b) {
  constexpr double kSmallestVariance = 1e-10;
  const glm::dvec3 difference = glm::dvec3(a) - glm::dvec3(b);
  return {dot(difference, difference), a.w + b.w + kSmallestVariance};
}

/// A statistic of single pixels is divided by this before membership(), since it varies more than that of patches.
inline constexpr double kPixelTolerance = 4;

/// Returns m(t), from 0 to 1, of a statistic of at least 0.
inline double membership(double statistic) {
  constexpr double kFull = 0.3, kNone = 1.5;
  return std::clamp((kNone - statistic) / (kNone - kFull), 0.0, 1.0);
}

/// Returns G of a guide, from 0 to 1. The variance of a mean is in `w`.
inline double guideWeight(const glm::dvec4& a, const glm::dvec4& b, double width) {
  constexpr double kGuideNoise = 2;
  const glm::dvec3 difference = glm::dvec3(a) - glm::dvec3(b);
  const double excess = dot(difference, difference) - kGuideNoise * (a.w + b.w);
  return std::max(0.0, 1 - std::max(0.0, excess) / (width * width));
}

/// Returns the product of the weights of the normal and of the reflectance.
inline double guideWeight(const gpu::DenoisePixel& a, const gpu::DenoisePixel& b) {
  constexpr double kNormalWidth = 0.3, kReflectanceWidth = 0.5;
  return guideWeight(a.normal, b.normal, kNormalWidth) * guideWeight(a.reflectance, b.reflectance, kReflectanceWidth);
}

}  // namespace candela::denoise

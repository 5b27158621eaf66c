// The difference between two images, as numbers and as a picture.
#pragma once
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "host/image/image.h"

namespace candela::image {

/// Two values are equal if they differ by at most `absolute`, or by at most `relative` times the reference value.
struct DifferenceTolerance {
  double relative = 1e-4;
  double absolute = 0x1p-26;
};

/// The difference between an image `a` and a reference `b`, in linear light and double precision; luminance is that of
/// Rec. 709. Pixels with a value in either image that is not finite are counted and otherwise ignored.
struct ImageComparison {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint64_t notFiniteCount = 0;  ///< pixels that are ignored

  glm::dvec3 mean{0};  ///< mean of a
  glm::dvec3 referenceMean{0};
  double meanLuminance = 0;
  double referenceMeanLuminance = 0;
  /// (mean a - mean b) / mean b of the luminance; 0 if both are 0, infinite if only that of b is.
  double relativeMeanDifference = 0;

  double meanSquaredError = 0;  ///< mean of (a - b)^2 over pixels and channels
  /// Mean of (a - b)^2 / (b^2 + 0.01) over pixels and channels: the relative MSE of Rousselle, Knaus and Zwicker,
  /// "Adaptive Sampling and Reconstruction using Greedy Error Minimization" (2011), with the usual epsilon.
  double relativeMeanSquaredError = 0;
  /// 10 log10(1 / MSE) in dB, after both images are clamped to [0, 1], in linear light and without a tone curve;
  /// infinite if they are then equal.
  double peakSignalToNoise = 0;

  double maximumDifference = 0;  ///< maximum of |a - b| over all channels
  std::int64_t maximumX = 0;     ///< the first pixel with this difference, row by row, in the plane of the picture
  std::int64_t maximumY = 0;
  DifferenceTolerance tolerance;
  std::uint64_t differingCount = 0;  ///< pixels with a channel beyond the tolerance
  /// differingCount as a fraction of the compared pixels; 0 if there are none.
  double differingFraction = 0;
};

/// Throws UsageError if the sizes differ.
ImageComparison compareImages(const Image& a, const Image& reference, const DifferenceTolerance& tolerance = {});

/// Returns lines of text, each ending in a newline.
std::string toText(const ImageComparison& comparison);
/// Returns whether every pixel has equal colours.
bool isIdentical(const ImageComparison& comparison);
/// Returns the numbers as docs/json.md names them. JSON has no infinity: such numbers are null.
nlohmann::ordered_json toJson(const ImageComparison& comparison);

/// Returns the value, > 0, that is added to the reference's luminance in relative differences of pixels: 1 % of its
/// mean luminance. Throws UsageError if the sizes differ.
double differenceScale(const Image& a, const Image& reference);

/// Returns the signed relative difference of the luminances, d = (a - b) / (b + scale), as colours: black where equal,
/// orange where a is brighter, blue where it is darker, full strength at |d| >= `range`; magenta where a value is not
/// finite. `scale` is that of differenceScale(), so that dark pixels do not dominate. Throws UsageError if the sizes
/// differ or `range` is not positive. Write it as PNG with ToneMap::srgb.
Image differencePicture(const Image& a, const Image& reference, double range = 0.1);

}  // namespace candela::image

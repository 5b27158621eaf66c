// How much one image differs from another, in numbers and as a picture.
#pragma once
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "host/image/image.h"

namespace candela::image {

/// Two values count as equal if they differ by at most `absolute` or by at most `relative` times the reference's.
struct DifferenceTolerance {
  double relative = 1e-4;
  double absolute = 0x1p-26;
};

/// `a` is the image in question, `b` the reference; all in linear light, in double precision, luminance Rec. 709.
/// Pixels in which either image has a value that is not finite are counted and left out of everything else.
struct ImageComparison {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint64_t notFiniteCount = 0;  ///< pixels left out

  glm::dvec3 mean{0};  ///< of a
  glm::dvec3 referenceMean{0};
  double meanLuminance = 0;
  double referenceMeanLuminance = 0;
  /// (mean a - mean b) / mean b of the luminance; 0 if both are 0, infinite if b's alone is.
  double relativeMeanDifference = 0;

  double meanSquaredError = 0;  ///< mean of (a - b)^2 over pixels and channels
  /// Mean of (a - b)^2 / (b^2 + 0.01) over pixels and channels: the relative MSE of Rousselle, Knaus and Zwicker,
  /// "Adaptive Sampling and Reconstruction using Greedy Error Minimization" (2011), with the usual epsilon.
  double relativeMeanSquaredError = 0;
  /// 10 log10(1 / MSE) in dB where both images are first clamped to [0, 1], still in linear light and without a tone
  /// curve; infinite if they are then equal.
  double peakSignalToNoise = 0;

  double maximumDifference = 0;  ///< largest |a - b| of a channel
  std::uint32_t maximumX = 0;    ///< where; the first such pixel, row by row
  std::uint32_t maximumY = 0;
  DifferenceTolerance tolerance;
  std::uint64_t differingCount = 0;  ///< pixels with a channel beyond the tolerance
  /// differingCount as a share of the pixels that were compared; 0 if there are none.
  double differingShare = 0;
};

/// Throws UsageError if the sizes differ.
ImageComparison compareImages(const Image& a, const Image& reference, const DifferenceTolerance& tolerance = {});

/// Some lines for people, each ending in a newline.
std::string toText(const ImageComparison& comparison);
/// The same numbers under the names of the fields. JSON has no infinity: such numbers are null.
nlohmann::ordered_json toJson(const ImageComparison& comparison);

/// What is added to the reference's luminance in relative differences of pixels, > 0. Throws UsageError if the sizes
/// differ.
double differenceScale(const Image& a, const Image& reference);

/// Signed relative difference of the luminances, d = (a - b) / (b + scale), as colours: black where equal, orange where
/// a is brighter, blue where it is darker, full strength at |d| >= `range`; magenta where a value is not finite.
/// `scale` is 1 % of the reference's mean luminance, so that dark pixels do not outshine the rest (differenceScale).
/// Throws UsageError if the sizes differ or `range` is not positive. Written as PNG with ToneMap::srgb it shows these
/// colours as they are.
Image differencePicture(const Image& a, const Image& reference, double range = 0.1);

}  // namespace candela::image

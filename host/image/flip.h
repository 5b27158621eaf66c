// The FLIP difference evaluator: how visible the difference between two images is when they are shown alternately.
#pragma once
#include <cstdint>
#include <vector>

#include "host/image/image.h"

namespace candela::image {

/// Pixels per degree of a display with 3840 pixels across 0.7 m, at a distance of 0.7 m: (3840 / 0.7 m) * 0.7 m * pi /
/// 180.
inline constexpr double kFlipPixelsPerDegree = 67.02064327658226;

struct FlipResult {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<float> error;  ///< per pixel, row by row from the top; 0 (no visible difference) to 1
  double mean = 0;           ///< mean of the error before rounding to binary32
  double maximum = 0;
};

/// Computes LDR-FLIP of Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom and Fairchild, "FLIP: A Difference
/// Evaluator for Alternating Images" (HPG 2020). The images are display-referred: linear Rec. 709 light, which is
/// clamped to [0, 1]; NaN is taken as 0. To compare images as a tone curve shows them, pass linear radiance through
/// `displayed` first. Throws UsageError if the sizes differ or pixelsPerDegree is outside [1, 1000].
FlipResult computeFlip(const Image& test, const Image& reference, double pixelsPerDegree = kFlipPixelsPerDegree);

/// Returns an image as a display shows it: the 8-bit pixels of the transform, as linear light.
Image displayed(const Image& image, const DisplayTransform& transform);

/// Returns the error map in the colours of "magma", black for 0. Write it as PNG with ToneMap::srgb.
Image errorPicture(const FlipResult& result);

}  // namespace candela::image

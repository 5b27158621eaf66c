// The FLIP difference evaluator: how visible the difference of two images is to somebody who flips between them.
#pragma once
#include <cstdint>
#include <vector>

#include "host/image/image.h"

namespace candela::image {

/// A display of 3840 pixels over 0.7 m, seen from 0.7 m: (3840 / 0.7 m) * 0.7 m * pi / 180.
inline constexpr double kFlipPixelsPerDegree = 67.02064327658226;

struct FlipResult {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<float> error;  ///< a pixel, row by row from the top; 0 (no visible difference) to 1
  double mean = 0;           ///< of the error before it was rounded to binary32
  double maximum = 0;
};

/// LDR-FLIP of Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom and Fairchild, "FLIP: A Difference Evaluator for
/// Alternating Images" (HPG 2020). The images are display-referred: linear Rec. 709 light, clamped to [0, 1], NaN taken
/// for 0. Pass linear radiance through `displayed` first to compare what a tone curve shows. Throws UsageError if the
/// sizes differ or pixelsPerDegree is outside [1, 1000].
FlipResult computeFlip(const Image& test, const Image& reference, double pixelsPerDegree = kFlipPixelsPerDegree);

/// What a display shows of an image: the 8-bit pixels of the transform as linear light.
Image displayed(const Image& image, const DisplayTransform& transform);

/// The error map in the colours of "magma", black for 0; written as PNG with ToneMap::srgb it shows them as they are.
Image errorPicture(const FlipResult& result);

}  // namespace candela::image

// Limits pixels that are bright because of few samples: docs/denoising.md, section 2.
#pragma once
#include <cstddef>

#include "host/trace/denoise/pixel_statistics.h"

namespace candela::denoise {

/// The light that limitIsolatedSamples() has taken away.
struct LimitedLight {
  std::size_t pixelCount = 0;
  double removedFraction = 0;  ///< of the luminance of all pixels that are filtered, 0 to 1
};

/// Scales the light of pixels that exceed their neighbours because of few samples, and its statistics, as if all
/// samples of the pixel were darker by one factor.
LimitedLight limitIsolatedSamples(PixelStatistics& statistics);

}  // namespace candela::denoise

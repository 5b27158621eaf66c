// The part of a band that gets samples.
#pragma once
#include <cstdint>
#include <vector>

#include "host/trace/device/tile_cursor.h"
#include "host/trace/render/pixel_mask.h"

namespace candela::device {

/// Rows first .. first + height - 1 of the film.
struct BandRows {
  std::uint32_t first = 0;
  std::uint32_t height = 0;
};

struct SampledRegion {
  Rect box;                                   ///< bounding box of the pixels that get samples, in the band
  std::vector<std::uint32_t> selectedInRows;  ///< number of such pixels in each row of the box
};

/// Returns the sampled region of rows of a film of this width. It covers the whole band if the mask selects none of its
/// pixels.
SampledRegion sampledRegionOf(BandRows rows, std::uint32_t width, const render::PixelMask& mask);

}  // namespace candela::device

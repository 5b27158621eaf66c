// The parts of an image whose light two tracers are compared on: all of it, and tiles of three sizes.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "host/image/film.h"
#include "host/render/extent.h"

namespace candela::verify {

/// Pixels x .. x + width - 1 by y .. y + height - 1, and the quantity that is averaged over them.
struct Region {
  enum class Quantity : std::uint8_t { luminance, red, green, blue };
  std::uint32_t x = 0, y = 0, width = 0, height = 0;
  std::uint32_t tileSize = 0;  ///< 8, 16 or 32; 0: the whole image
  Quantity quantity = Quantity::luminance;
};

/// The whole image by luminance, first, and by channel; then its luminance in tiles of 8, 16 and 32 pixels a side, cut
/// at the right and lower edge. Tile sizes that would have a single tile are left out.
std::vector<Region> regionsOf(const render::Extent& image);

/// "image mean (luminance)" or "tile 8x8 at 16,24".
std::string regionText(const Region& region);
/// "luminance", "red", "green" or "blue".
const char* quantityName(Region::Quantity quantity);

/// The mean over a region's pixels of the means of their samples. Every pixel has samples.
double regionMean(const image::Film& film, const Region& region);

}  // namespace candela::verify

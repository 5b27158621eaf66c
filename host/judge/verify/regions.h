// The regions of an image in which the light of two tracers is compared: the whole image, and tiles of three sizes.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/image/film.h"
#include "host/image/image.h"
#include "host/trace/render/extent.h"

namespace candela::verify {

/// Pixels x .. x + width - 1 and y .. y + height - 1, and the quantity that is averaged over them.
struct Region {
  enum class Quantity : std::uint8_t { luminance, red, green, blue };
  std::uint32_t x = 0, y = 0, width = 0, height = 0;
  std::uint32_t tileSize = 0;  ///< 8, 16 or 32; 0: the whole image
  Quantity quantity = Quantity::luminance;
};

/// Returns the luminance of the whole image, then its channels, then the luminance of tiles of 8, 16 and 32 pixels per
/// side, cut at the right and lower edge. Sizes that would give a single tile are omitted. A watched region comes last.
std::vector<Region> regionsOf(const render::Extent& image, const std::optional<Region>& watched = std::nullopt);

/// Returns e.g. "image mean (luminance)" or "tile 8x8 at 16,24".
std::string regionText(const Region& region);
/// Returns "luminance", "red", "green" or "blue".
const char* quantityName(Region::Quantity quantity);

/// Returns the luminance or a channel of a colour.
double quantityOf(const glm::dvec3& rgb, Region::Quantity quantity);

/// Returns the mean over the pixels of a region, each of which must have samples.
double regionMean(const image::Film& film, const Region& region);
double regionMean(const image::Image& image, const Region& region);

}  // namespace candela::verify

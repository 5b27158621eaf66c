// Lists the regions of an image, and computes their means.
#include "host/judge/verify/regions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace candela::verify {
namespace {

void appendTiles(const render::Extent& image, std::uint32_t size, std::vector<Region>& regions) {
  if (image.width <= size && image.height <= size) return;
  for (std::uint32_t y = 0; y < image.height; y += size) {
    for (std::uint32_t x = 0; x < image.width; x += size) {
      regions.push_back(
          {x, y, std::min(size, image.width - x), std::min(size, image.height - y), size, Region::Quantity::luminance});
    }
  }
}

template <class ColourAt>
double meanOver(const Region& region, ColourAt colourAt) {
  double sum = 0;
  for (std::uint32_t y = region.y; y < region.y + region.height; ++y) {
    for (std::uint32_t x = region.x; x < region.x + region.width; ++x) {
      sum += quantityOf(colourAt(x, y), region.quantity);
    }
  }
  return sum / (double{1} * region.width * region.height);
}

}  // namespace

std::vector<Region> regionsOf(const render::Extent& image, const std::optional<Region>& watched) {
  std::vector<Region> regions;
  for (const auto quantity :
       {Region::Quantity::luminance, Region::Quantity::red, Region::Quantity::green, Region::Quantity::blue}) {
    regions.push_back({0, 0, image.width, image.height, 0, quantity});
  }
  for (const std::uint32_t size : {8u, 16u, 32u}) appendTiles(image, size, regions);
  if (watched) regions.push_back(*watched);
  return regions;
}

const char* quantityName(Region::Quantity quantity) {
  constexpr std::array<const char*, 4> kNames{"luminance", "red", "green", "blue"};
  return kNames[static_cast<std::size_t>(quantity)];
}

std::string regionText(const Region& region) {
  if (region.tileSize == 0) return fmt::format("image mean ({})", quantityName(region.quantity));
  return fmt::format("tile {}x{} at {},{}", region.tileSize, region.tileSize, region.x, region.y);
}

double quantityOf(const glm::dvec3& rgb, Region::Quantity quantity) {
  switch (quantity) {
    case Region::Quantity::red:
      return rgb.r;
    case Region::Quantity::green:
      return rgb.g;
    case Region::Quantity::blue:
      return rgb.b;
    case Region::Quantity::luminance:
      break;
  }
  return image::luminance(rgb);
}

double regionMean(const image::Film& film, const Region& region) {
  return meanOver(region, [&](std::uint32_t x, std::uint32_t y) { return film.mean(x, y); });
}

double regionMean(const image::Image& image, const Region& region) {
  return meanOver(region, [&](std::uint32_t x, std::uint32_t y) { return glm::dvec3(image.at(x, y)); });
}

}  // namespace candela::verify

// Draws the pictures of a report.
#include "host/judge/report/maps.h"

#include <fmt/format.h>

#include "host/judge/report/reduce.h"
#include "host/judge/report/tile_map.h"

namespace candela::report {
namespace {

constexpr double kDifferenceRange = 0.1;
constexpr image::DisplayTransform kAsItIs{};  // for pictures that are already display-referred

image::Pixels8 reducedPixels(const image::Image& picture, std::uint32_t k) {
  return toPixels8(k == 1 ? picture : reduced(picture, k), kAsItIs);
}

Map differenceMap(const Report& report, std::uint32_t k) {
  return {
      "map-difference", "Differences",
      fmt::format("Luminance, relative to B. Black: equal; orange: A is brighter; blue: A is darker; full colour at "
                  "{:g} %; magenta: not a number.",
                  100 * kDifferenceRange),
      reducedPixels(differencePicture(report.a, report.b, kDifferenceRange), k)};
}

Map flipMap(const Report& report, std::uint32_t k) {
  return {"map-flip", "FLIP",
          fmt::format(
              "Visibility of the difference when A and B are shown alternately: black 0, pale yellow 1. Mean {:.4g}, "
              "maximum {:.4g}.",
              report.flip.mean, report.flip.maximum),
          reducedPixels(errorPicture(report.flip), k)};
}

Map testMap(const Report& report, std::uint32_t tileSize, std::uint32_t k) {
  const image::Pixels8 map = tileMap(report.tests->regions, tileSize, report.tests->level, report.a.width,
                                     report.a.height);
  return {fmt::format("map-t{}", tileSize), fmt::format("t of tiles, {0} × {0} pixels", tileSize),
          "Welch's t. Black: 0; orange: A is brighter; blue: A is darker; full colour and a white frame: significant.",
          k == 1 ? map : reducedPixels(toImage(map), k)};
}

}  // namespace

image::Pixels8 sidePicture(const image::Image& image, const image::DisplayTransform& display, std::uint32_t k) {
  return toPixels8(k == 1 ? image : reduced(image, k), display);
}

std::vector<Map> mapsOf(const Report& report, std::uint32_t k) {
  std::vector<Map> maps{differenceMap(report, k), flipMap(report, k)};
  if (!report.tests) return maps;
  for (const std::uint32_t size : tileSizes(report.tests->regions)) maps.push_back(testMap(report, size, k));
  return maps;
}

}  // namespace candela::report

// The regions in which two images are compared, and the seeds of batches.
#include "host/judge/verify/regions.h"

#include <catch2/catch.hpp>

#include "host/judge/verify/batches.h"

namespace candela::verify {
namespace {

std::size_t tilesOf(const std::vector<Region>& regions, std::uint32_t size) {
  std::size_t count = 0;
  for (const Region& region : regions) count += region.tileSize == size ? 1 : 0;
  return count;
}

TEST_CASE("an image is compared as a whole, by channel, and in tiles of three sizes") {
  const std::vector<Region> regions = regionsOf({64, 48});
  CHECK(tilesOf(regions, 0) == 4);
  CHECK(tilesOf(regions, 8) == 48);
  CHECK(tilesOf(regions, 16) == 12);
  CHECK(tilesOf(regions, 32) == 4);
  CHECK(regions.front().quantity == Region::Quantity::luminance);
  CHECK(regions.front().width == 64);
}

TEST_CASE("tiles cover every pixel once, and sizes that would give a single tile are omitted") {
  const std::vector<Region> regions = regionsOf({19, 9});
  CHECK(tilesOf(regions, 32) == 0);
  std::size_t pixels = 0;
  for (const Region& region : regions) {
    CHECK(region.x + region.width <= 19);
    CHECK(region.y + region.height <= 9);
    if (region.tileSize == 8) pixels += std::size_t{region.width} * region.height;
  }
  CHECK(pixels == 19 * 9);
}

TEST_CASE("the mean of a region is that of its quantity over its pixels") {
  image::Film film(2, 1);
  film.addSample(0, 0, {1, 2, 3}, 0);
  film.addSample(1, 0, {3, 2, 1}, 0);
  film.addSample(1, 0, {5, 2, 1}, 1);
  CHECK(regionMean(film, {0, 0, 2, 1, 0, Region::Quantity::red}) == Approx(2.5));
  CHECK(regionMean(film, {0, 0, 2, 1, 0, Region::Quantity::luminance}) ==
        Approx(0.2126 * 2.5 + 0.7152 * 2 + 0.0722 * 2));
  CHECK(regionMean(film, {1, 0, 1, 1, 8, Region::Quantity::red}) == Approx(4));
}

TEST_CASE("no two batches of a run have the same seed") {
  std::vector<std::uint32_t> seeds;
  for (const verify::Side side : {verify::Side::device, verify::Side::reference}) {
    for (std::uint32_t look = 0; look < 8; ++look) {
      for (std::uint32_t batch = 0; batch < 256; ++batch) seeds.push_back(batchSeed(7, side, batch, look));
    }
  }
  std::sort(seeds.begin(), seeds.end());
  CHECK(std::adjacent_find(seeds.begin(), seeds.end()) == seeds.end());
  CHECK(batchSeed(7, verify::Side::device, 0, 0) != batchSeed(8, verify::Side::device, 0, 0));
}

}  // namespace
}  // namespace candela::verify

// Every sweep covers every pixel once, whatever sizes are requested.
#include "host/trace/device/tile_cursor.h"

#include <catch2/catch.hpp>
#include <functional>
#include <random>
#include <vector>

using namespace candela;
using namespace candela::device;

namespace {

/// Returns how often each pixel was in a rectangle of one sweep. Fails if a rectangle is empty or extends beyond the
/// image.
std::vector<int> sweep(
    TileCursor& cursor, render::Extent image, const std::function<std::uint64_t()>& wanted,
    const std::function<void(std::uint64_t, const Rect&)>& check = [](std::uint64_t, const Rect&) {}) {
  std::vector<int> visits(std::size_t{image.width} * image.height);
  do {
    const std::uint64_t pixels = wanted();
    const Rect rect = cursor.next(pixels);
    REQUIRE(rect.width > 0);
    REQUIRE(rect.height > 0);
    REQUIRE(rect.x + rect.width <= image.width);
    REQUIRE(rect.y + rect.height <= image.height);
    check(pixels, rect);
    for (std::uint32_t y = rect.y; y < rect.y + rect.height; ++y) {
      for (std::uint32_t x = rect.x; x < rect.x + rect.width; ++x) ++visits[std::size_t{y} * image.width + x];
    }
  } while (!cursor.isAtStart());
  return visits;
}

std::vector<int> once(render::Extent image) { return std::vector<int>(std::size_t{image.width} * image.height, 1); }

std::vector<Rect> pieces(TileCursor cursor, std::uint64_t wanted) {
  std::vector<Rect> rects;
  do {
    rects.push_back(cursor.next(wanted));
  } while (!cursor.isAtStart());
  return rects;
}

bool isRect(const Rect& rect, std::uint32_t x, std::uint32_t y, std::uint32_t width, std::uint32_t height) {
  return rect.x == x && rect.y == y && rect.width == width && rect.height == height;
}

}  // namespace

TEST_CASE("each sweep covers each pixel once for random sizes of image, workgroup and rectangles") {
  std::mt19937 random(7);
  const auto upTo = [&](std::uint32_t most) { return std::uniform_int_distribution<std::uint32_t>(1, most)(random); };
  for (int round = 0; round < 200; ++round) {
    const render::Extent image{upTo(100), upTo(100)};
    const render::Extent workgroup{upTo(20), upTo(20)};
    const std::uint32_t most = upTo(3 * image.width * image.height);
    TileCursor cursor(image, workgroup);
    const auto check = [&](std::uint64_t wanted, const Rect& rect) {
      CHECK(std::uint64_t{rect.width} * rect.height <=
            std::max<std::uint64_t>(wanted, std::uint64_t{workgroup.width} * workgroup.height));
      CHECK(rect.x % workgroup.width == 0);
      CHECK(rect.y % workgroup.height == 0);
    };
    for (int i = 0; i < 3; ++i)
      CHECK(sweep(
                cursor, image, [&] { return upTo(most); }, check) == once(image));
  }
}

TEST_CASE("rectangles have at most the requested size, or one workgroup, and are aligned to workgroups") {
  const std::vector<Rect> rects = pieces(TileCursor({100, 50}, {8, 8}), 8 * 20);
  CHECK(isRect(rects[0], 0, 0, 16, 8));
  CHECK(isRect(rects[1], 16, 0, 16, 8));
  CHECK(isRect(rects.back(), 56, 48, 44, 2));  // two rows are left: 80 across would do
}

TEST_CASE("an image requested as one region is one rectangle") {
  CHECK(isRect(pieces(TileCursor({100, 50}, {8, 8}), 5000).at(0), 0, 0, 100, 50));
  CHECK(pieces(TileCursor({100, 50}, {8, 8}), 5000).size() == 1);
  CHECK(pieces(TileCursor({100, 50}, {8, 8}), ~std::uint64_t{0}).size() == 1);
}

TEST_CASE("full strips are divided evenly without a small remainder") {
  const std::vector<Rect> rects = pieces(TileCursor({100, 1000}, {8, 8}), 100 * 300);
  REQUIRE(rects.size() == 4);  // 296 rows at most
  CHECK(isRect(rects[0], 0, 0, 100, 256));
  CHECK(isRect(rects[1], 0, 256, 100, 248));
  CHECK(isRect(rects[2], 0, 504, 100, 248));
  CHECK(isRect(rects[3], 0, 752, 100, 248));
}

TEST_CASE("fixed tiles of any size cover the image row by row") {
  const TileCursor cursor = TileCursor::ofTiles({70, 40}, {32, 30});
  for (const std::uint64_t wanted : {std::uint64_t{1}, std::uint64_t{1000000}}) {
    const std::vector<Rect> rects = pieces(cursor, wanted);
    REQUIRE(rects.size() == 6);
    CHECK(isRect(rects[0], 0, 0, 32, 30));
    CHECK(isRect(rects[2], 64, 0, 6, 30));
    CHECK(isRect(rects[3], 0, 30, 32, 10));
    CHECK(isRect(rects[5], 64, 30, 6, 10));
  }
  TileCursor sweeping = cursor;
  CHECK(sweep(sweeping, {70, 40}, [] { return std::uint64_t{5}; }) == once({70, 40}));
}

TEST_CASE("iterating over an image of the maximum size does not overflow") {
  TileCursor cursor({65535, 65535}, {8, 8});
  const Rect first = cursor.next(std::uint64_t{1} << 33);
  CHECK(isRect(first, 0, 0, 65535, 65535));
  CHECK(cursor.isAtStart());
}

TEST_CASE("a cursor moves to the start of the strip that contains a row") {
  TileCursor cursor({100, 50}, {16, 8});
  cursor.next(200);
  cursor.moveTo(25);
  CHECK(isRect(cursor.next(800), 0, 24, 100, 8));
  cursor.moveTo(7);
  CHECK(cursor.isAtStart());
  cursor.moveTo(99);
  CHECK(isRect(cursor.next(800), 0, 48, 100, 2));
}

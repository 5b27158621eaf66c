// Numbers of samples by columns, compared with those of all boxes one by one.
#include "host/job/film/coverage_check.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "host/base/errors.h"
#include "tests/job/film/made_films.h"

using namespace candela;
using namespace candela::film;

namespace {

constexpr render::Window kPart{5, 9, 40, 30};
constexpr std::uint32_t kSampleCount = 20;

// Boxes of random tiles, whose sizes do not fit together.
std::vector<SampleBox> randomBoxes(std::mt19937& random) {
  std::vector<SampleBox> boxes;
  for (std::uint32_t y = 0; y + 7 <= kPart.height; y += 7) {
    for (std::uint32_t x = 0; x + 9 <= kPart.width; x += 9) {
      const auto first = static_cast<std::uint32_t>(random() % kSampleCount);
      const auto width = 1 + static_cast<std::uint32_t>(random() % 9),
                 height = 1 + static_cast<std::uint32_t>(random() % 7);
      boxes.push_back({{kPart.x + x, kPart.y + y, width, height}, {first, first + 1}});
      if (first + 2 < kSampleCount) boxes.push_back({boxes.back().window, {first + 2, kSampleCount}});
    }
  }
  return canonicalBoxes(boxes);
}

bool isIn(const render::Window& window, std::uint32_t x, std::uint32_t y) {
  return x >= window.x && x - window.x < window.width && y >= window.y && y - window.y < window.height;
}

}  // namespace

TEST_CASE("coverage: the samples of each column of a row are those of the boxes that contain it") {
  std::mt19937 random(1);
  for (int run = 0; run < 20; ++run) {
    const std::vector<SampleBox> boxes = randomBoxes(random);
    ColumnCounts counts(boxes, kPart, kSampleCount);
    const auto step = 1 + static_cast<std::uint32_t>(random() % 3);
    for (std::uint32_t y = kPart.y; y < kPart.y + kPart.height; y += step) {
      const std::span<const ColumnCounts::Count> row = counts.at(y);
      for (std::uint32_t x = 0; x < kPart.width; ++x) {
        std::uint32_t samples = 0, last = 0;
        for (const auto& [window, range] : boxes) {
          if (!isIn(window, kPart.x + x, y)) continue;
          samples += range.end - range.first;
          last += range.end == kSampleCount ? 1 : 0;
        }
        INFO("run " << run << ", pixel " << kPart.x + x << ", " << y);
        CHECK(row[x].samples == samples);
        CHECK(row[x].last == last);
      }
    }
  }
}

TEST_CASE("coverage: only pixels whose last sample is covered may have stopped before, after the pilot") {
  FilmHeader header = madeHeader({4, 2}, 256);
  header.settings["noise-threshold"] = "0.1";
  const std::uint32_t pilot = render::pilotSamples(0.1);
  REQUIRE(pilot < 200);
  header.covered = {{{0, 0, 2, 2}, {0, 256}}, {{2, 0, 2, 2}, {0, 200}}};
  std::vector<image::FilmPixel> row(4);
  for (image::FilmPixel& pixel : row) pixel.sampleCount = 200;
  CHECK_NOTHROW(CoverageCheck(header).checkRow(1, row));
  row[1].sampleCount = pilot;
  CHECK_NOTHROW(CoverageCheck(header).checkRow(1, row));
  row[2].sampleCount = pilot;
  CHECK_THROWS_WITH(CoverageCheck(header).checkRow(1, row), Catch::Contains("pixel (2, 1) holds"));
  row[2].sampleCount = 200;
  row[1].sampleCount = pilot - 1;
  CHECK_THROWS_WITH(CoverageCheck(header).checkRow(1, row), Catch::Contains("pixel (1, 1) holds"));
}

// Histograms, compared with counts computed by hand, and the reduction of large pictures.
#include "host/judge/report/histogram.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "host/judge/report/reduce.h"

namespace candela::report {
namespace {

image::Image greys(const std::vector<float>& values, std::uint32_t width) {
  image::Image image;
  image.width = width;
  image.height = static_cast<std::uint32_t>(values.size()) / width;
  for (const float value : values) image.rgb.emplace_back(value);
  return image;
}

TEST_CASE("a histogram counts values outside its range in the outermost bins and ignores values that are not finite") {
  Histogram histogram(0, 4, 4);
  for (const double value : {0.0, 0.9, 1.0, 3.9, 4.0, 99.0, -99.0}) histogram.add(value);
  histogram.add(NAN);
  histogram.add(HUGE_VAL);
  CHECK(histogram.counts == std::vector<std::uint64_t>{3, 1, 0, 3});
  CHECK(histogram.leftOut == 2);
}

TEST_CASE("histograms of luminance have two bins per stop, common to both images") {
  const auto [a, b] = valueHistograms(greys({0.3f, 0.3f, 0}, 3), greys({1.1f, 1.6f, 3}, 3));
  // From 2^-2 to 2^2; log2 of 0.3 is -1.74, of 1.1 0.14, of 1.6 0.68, of 3 1.58.
  CHECK(a.low == -2);
  CHECK(a.high == 2);
  CHECK(a.counts == std::vector<std::uint64_t>{2, 0, 0, 0, 0, 0, 0, 0});
  CHECK(a.leftOut == 1);
  CHECK(b.counts == std::vector<std::uint64_t>{0, 0, 0, 0, 1, 1, 0, 1});
}

TEST_CASE("images without light, or with a very large range, still have a histogram") {
  CHECK(valueHistograms(greys({0}, 1), greys({0}, 1)).a.counts.size() == 2);
  CHECK(valueHistograms(greys({1e-30f}, 1), greys({1e30f}, 1)).b.counts.size() == 48);
}

TEST_CASE("the range of differences contains 99 % of the pixels") {
  std::vector<float> values(1000, 1.0f);
  CHECK(differenceHistogram(greys(values, 100), greys(values, 100)).high == 0.001);
  for (std::size_t i = 0; i < 11; ++i) values[i] = 1.05f;
  CHECK(differenceHistogram(greys(values, 100), greys(std::vector<float>(1000, 1.0f), 100)).high == 0.1);
  const Histogram histogram = differenceHistogram(greys({9}, 1), greys({1}, 1));
  CHECK(histogram.high == 10);
  CHECK(histogram.counts[20 + 16] == 1);  // (9 - 1) / 1.01 = 7.92, in bins of 20/41
}

TEST_CASE("pictures are reduced to means of blocks by the minimum whole factor that suffices") {
  CHECK(reductionOf(1024, 1024) == 1);
  CHECK(reductionOf(1025, 1024) == 2);
  CHECK(reductionOf(65535, 4096) == 16);
  const image::Image small = reduced(greys({1, 3, 5, 7, 9, 11}, 3), 2);
  REQUIRE(small.width == 2);
  REQUIRE(small.height == 1);
  CHECK(small.rgb[0].r == (1 + 3 + 7 + 9) / 4.0f);
  CHECK(small.rgb[1].r == (5 + 11) / 2.0f);
}

}  // namespace
}  // namespace candela::report

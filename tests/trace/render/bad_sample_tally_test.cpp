// The tally of bad samples over several renders.
#include "host/trace/render/bad_sample_tally.h"

#include <catch2/catch.hpp>

using namespace candela;

namespace {

const glm::dvec3 kTooBright(1e9);

render::ImageSettings settingsOf(std::uint32_t seed) {
  render::ImageSettings image;
  image.size = {4, 3};
  image.seed = seed;
  image.sampleCount = 8;
  return image;
}

}  // namespace

TEST_CASE("films without bad samples leave a tally empty") {
  render::BadSampleTally tally;
  image::Film film(4, 3);
  film.addSample(0, 0, glm::dvec3(1), 0);
  tally.add(film, settingsOf(1));
  CHECK(tally.samples() == 0);
  CHECK(tally.pixels() == 0);
  CHECK(tally.firstPixels().empty());
}

TEST_CASE("a tally adds the samples of all renders, and counts a pixel once with its first bad sample") {
  render::BadSampleTally tally;
  image::Film first(4, 3);
  first.addSample(1, 2, kTooBright, 7);
  first.addSample(1, 2, glm::dvec3(-1), 5);
  tally.add(first, settingsOf(11));
  image::Film second(4, 3);
  second.addSample(1, 2, kTooBright, 0);
  second.addSample(3, 0, kTooBright, 4);
  tally.add(second, settingsOf(12));
  CHECK(tally.samples() == 4);
  CHECK(tally.pixels() == 2);
  CHECK(tally.firstPixels() == std::vector<render::BadPixel>{{1, 2, 2, 5, 11, 8}, {3, 0, 1, 4, 12, 8}});
}

TEST_CASE("a tally counts all bad pixels and lists the first") {
  image::Film film(4, 3);
  for (std::uint32_t i = 0; i < 12; ++i) film.addSample(i % 4, i / 4, kTooBright, 0);
  render::BadSampleTally tally;
  tally.add(film, settingsOf(0));
  CHECK(tally.pixels() == 12);
  REQUIRE(tally.firstPixels().size() == render::BadSampleTally::kPixelsKept);
  CHECK(tally.firstPixels().back().x == 0);
  CHECK(tally.firstPixels().back().y == 1);
}

TEST_CASE("a tally adds the counts of a later tally") {
  image::Film film(4, 3);
  film.addSample(1, 2, kTooBright, 7);
  render::BadSampleTally tally;
  tally.add(film, settingsOf(11));
  film.addSample(3, 0, kTooBright, 6);
  render::BadSampleTally later;
  later.add(film, settingsOf(12));
  tally.add(later);
  CHECK(tally.samples() == 3);
  CHECK(tally.pixels() == 2);
  CHECK(tally.firstPixels() == std::vector<render::BadPixel>{{1, 2, 1, 7, 11, 8}, {3, 0, 1, 6, 12, 8}});
  tally.add(render::BadSampleTally{});
  CHECK(tally.samples() == 3);
}

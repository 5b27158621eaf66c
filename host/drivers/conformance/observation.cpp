// Compares observations.
#include "host/drivers/conformance/observation.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>

namespace candela::conformance {
namespace {

bool areEqual(const image::FilmPixel& a, const image::FilmPixel& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

struct Quantity {
  const char* name;
  image::FixedSum value;
};

constexpr image::FixedSum countOf(std::uint32_t count) { return {0, count << 8, count >> 24}; }

std::array<Quantity, 8> quantitiesOf(const image::FilmPixel& pixel) {
  return {{{"sum of red", pixel.red},
           {"sum of green", pixel.green},
           {"sum of blue", pixel.blue},
           {"sum of squared luminances", pixel.luminanceSquared},
           {"number of samples", countOf(pixel.sampleCount)},
           {"number of bad samples", countOf(pixel.badCount)},
           {"first bad sample", countOf(pixel.firstBadSample)},
           {"number of hits", countOf(pixel.hitCount)}}};
}

// Names the first quantity that differs.
std::string pixelDifference(const image::FilmPixel& plain, const image::FilmPixel& other) {
  const auto a = quantitiesOf(plain), b = quantitiesOf(other);
  std::size_t i = 0;
  while (a[i].value == b[i].value) ++i;
  return fmt::format("{} is {:.15g} and {:.15g}", a[i].name, image::toDouble(a[i].value), image::toDouble(b[i].value));
}

std::string filmDifference(const image::Film& plain, const image::Film& other, const std::string& otherName) {
  const auto& a = plain.pixels();
  const auto& b = other.pixels();
  std::size_t differing = 0;
  for (std::size_t i = 0; i < a.size(); ++i) differing += areEqual(a[i], b[i]) ? 0 : 1;
  const auto first = static_cast<std::size_t>(std::ranges::mismatch(a, b, areEqual).in1 - a.begin());
  return fmt::format("the films of plain and {} differ in {} of {} pixels, first in {},{}: {}", otherName, differing,
                     a.size(), first % plain.width(), first / plain.width(), pixelDifference(a[first], b[first]));
}

std::string described(const Observation& one) { return one.text.empty() ? one.key : one.key + ", " + one.text; }

}  // namespace

std::string differenceBetween(const Observation& plain, const Observation& other, const std::string& otherName) {
  if (plain.key == other.key) return {};
  if (!plain.film.pixels().empty() && !other.film.pixels().empty()) {
    return filmDifference(plain.film, other.film, otherName);
  }
  return fmt::format("plain and {} differ: {} and {}", otherName, described(plain), described(other));
}

}  // namespace candela::conformance

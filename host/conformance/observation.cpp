// Compares observations.
#include "host/conformance/observation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace candela::conformance {
namespace {

bool areEqual(const image::FilmPixel& a, const image::FilmPixel& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

std::string valuesText(const glm::dvec3& rgb) { return fmt::format("({}, {}, {})", rgb.x, rgb.y, rgb.z); }

std::string filmDifference(const image::Film& plain, const image::Film& other, const std::string& otherName) {
  const auto& a = plain.pixels();
  const auto& b = other.pixels();
  std::size_t differing = 0;
  for (std::size_t i = 0; i < a.size(); ++i) differing += areEqual(a[i], b[i]) ? 0 : 1;
  const auto first = static_cast<std::size_t>(std::ranges::mismatch(a, b, areEqual).in1 - a.begin());
  const auto x = static_cast<std::uint32_t>(first % plain.width());
  const auto y = static_cast<std::uint32_t>(first / plain.width());
  return fmt::format("the films of plain and {} differ in {} of {} pixels, the first of which is {},{}: {} and {}",
                     otherName, differing, a.size(), x, y, valuesText(plain.mean(x, y)), valuesText(other.mean(x, y)));
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

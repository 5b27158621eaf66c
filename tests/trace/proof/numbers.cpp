// Generates numbers for the functions under proof.
#include "tests/trace/proof/numbers.h"

#include <cmath>
#include <numbers>
#include <random>

namespace candela::proof {
namespace {

float unitFraction(double value) {
  return static_cast<float>(std::floor((value - std::floor(value)) * 0x1p24) * 0x1p-24);
}

}  // namespace

std::vector<glm::vec3> randomNumbers(std::size_t count, std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto uniform = [&] { return static_cast<float>(random() >> 8) * 0x1p-24f; };
  std::vector<glm::vec3> numbers(count);
  for (glm::vec3& u : numbers) {
    for (int axis = 0; axis < 3; ++axis) u[axis] = uniform();
  }
  return numbers;
}

std::vector<glm::vec3> latticeNumbers(std::size_t count) {
  constexpr double kPlastic = 1.32471795724474602596;  // the real root of x^3 = x + 1
  std::vector<glm::vec3> numbers(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double k = static_cast<double>(i) + 0.5;
    numbers[i] = {unitFraction(k / static_cast<double>(count)), unitFraction(k / kPlastic),
                  unitFraction(k / (kPlastic * kPlastic))};
  }
  return numbers;
}

std::vector<glm::dvec3> latticeDirections(std::size_t count) {
  std::vector<glm::dvec3> directions(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double k = static_cast<double>(i) + 0.5;
    const double z = 1 - 2 * k / static_cast<double>(count);
    const double phi = 2 * std::numbers::pi * k / std::numbers::phi;
    const double r = std::sqrt(1 - z * z);
    directions[i] = {r * std::cos(phi), r * std::sin(phi), z};
  }
  return directions;
}

}  // namespace candela::proof

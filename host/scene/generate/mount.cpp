// mount: a mountain by midpoint displacement (Carpenter), with a pyramid of four glass balls in front of it.
#include <array>
#include <cmath>
#include <numbers>

#include "host/scene/generate/databases.h"
#include "host/scene/generate/rotation.h"

namespace candela::generate {
namespace {

constexpr double kFractalDimension = 2.2;
constexpr double kCorner = -1;  ///< minimum x and y of the mountain
constexpr double kWidth = 2;
constexpr std::uint64_t kMountainNumber = 21;  ///< seed of the mountain

/// Normally distributed random numbers, determined by the seed: the polar method on two linear congruential generators
/// (Press et al., Numerical Recipes, gasdev).
double gaussian(std::uint64_t seed) {
  constexpr std::uint64_t kModulus = 134456;
  const auto next = [](std::uint64_t x) { return (28411 + x * 8121) % kModulus; };
  const auto symmetric = [](std::uint64_t x) { return static_cast<double>(x) * 2 / kModulus - 1; };
  while (true) {
    const std::uint64_t first = next(seed);
    seed = next(first);
    const double a = symmetric(first);
    const double b = symmetric(seed);
    const double lengthSquared = a * a + b * b;
    if (lengthSquared < 1) return a * std::sqrt(-2 * std::log(lengthSquared) / lengthSquared);
  }
}

/// A square of cells. Its corners are in counter-clockwise order from the one with minimum coordinates.
struct Section {
  std::uint32_t x, y, width;  ///< in cells
  std::array<double, 4> height;
};

class Mountain {
 public:
  Mountain(NffWriter& out, std::uint32_t size) : out_(out), size_(size) {}

  void write() { grow({0, 0, 1u << size_, {0, 0, 0, 0}}); }

 private:
  double cells() const { return static_cast<double>(1u << size_); }
  double position(std::uint32_t cell) const { return kCorner + static_cast<double>(cell) * kWidth / cells(); }

  /// Scales `value` from cells to 2^-bits of the width of the mountain, which is 2^size cells.
  std::uint64_t scaled(std::uint32_t value, std::uint32_t bits) const {
    const std::uint64_t wide = value;
    return bits >= size_ ? wide << (bits - size_) : wide >> (size_ - bits);
  }

  /// Returns the displacement of the published database. Its random numbers repeat, but all published results depend on
  /// them.
  double displacement(std::uint32_t x, std::uint32_t y) const {
    const std::uint64_t hash = (scaled(x, 23) + scaled(y, 15) + scaled(x, 7)) & 0xffff;
    return gaussian(kMountainNumber + hash);
  }

  void grow(const Section& section) {
    if (section.width == 1) return writeCell(section);
    const auto& [x, y, width, corner] = section;
    const std::uint32_t half = width / 2;
    const double rise = static_cast<double>(half) * kWidth / cells() * roughness_;
    const auto middleOf = [&](double a, double b, std::uint32_t atX, std::uint32_t atY) {
      return (a + b) / 2 + rise * displacement(atX, atY);
    };
    const double lower = middleOf(corner[0], corner[1], x + half, y);
    const double right = middleOf(corner[1], corner[2], x + width, y + half);
    const double upper = middleOf(corner[2], corner[3], x + half, y + width);
    const double left = middleOf(corner[3], corner[0], x, y + half);
    constexpr double kDiagonal = 1.4142136;
    const double middle = (corner[0] + corner[1] + corner[2] + corner[3]) / 4 +
                          kDiagonal * rise * displacement(x + half, y + half);
    grow({x, y, half, {corner[0], lower, middle, left}});
    grow({x + half, y, half, {lower, corner[1], right, middle}});
    grow({x + half, y + half, half, {middle, right, corner[2], upper}});
    grow({x, y + half, half, {left, middle, upper, corner[3]}});
  }

  void writeCell(const Section& cell) {
    const double x[] = {position(cell.x), position(cell.x + 1)};
    const double y[] = {position(cell.y), position(cell.y + 1)};
    const glm::dvec3 a(x[0], y[0], cell.height[0]);
    const glm::dvec3 b(x[1], y[0], cell.height[1]);
    const glm::dvec3 c(x[1], y[1], cell.height[2]);
    const glm::dvec3 d(x[0], y[1], cell.height[3]);
    out_.polygon(std::array{a, b, c});
    out_.polygon(std::array{c, d, a});
  }

  /// Standard deviation of the displacement of a midpoint, as a fraction of half of the side that it divides.
  static double roughness() {
    const double ratio = 2 / std::exp2(1 / (kFractalDimension - 1));
    return std::sqrt(ratio * ratio - 1);
  }

  NffWriter& out_;
  std::uint32_t size_;
  double roughness_ = roughness();
};

void writePyramidOfBalls(NffWriter& out) {
  constexpr double kSphereRadius = 0.17;
  const glm::dvec3 middle(-0.8, 0.8, 1);
  const glm::dvec3 top(0, 0, kSphereRadius * std::sqrt(1.5));
  out.sphere(middle + top, kSphereRadius);
  // The angle between two corners of a tetrahedron, seen from its middle, has the cosine -1/3.
  const glm::dvec3 low = rotation(std::acos(-1.0 / 3), {1, 1, 0}) * top;
  for (int i = 0; i < 3; ++i) {
    out.sphere(rotation(i * 2 * std::numbers::pi / 3, {0, 0, 1}) * low + middle, kSphereRadius);
  }
}

}  // namespace

std::uint64_t mountPrimitives(std::uint32_t size) { return (std::uint64_t{2} << (2 * size)) + 4; }

void writeMount(NffWriter& out, std::uint32_t size) {
  out.background(kSkyBlue);
  out.view({{-1.6, 1.6, 1.7}, {0, 0, 0}, {0, 0, 1}, 45, 0.01});
  out.light({-100, -100, 100});
  out.surface({{1, 1, 1}, 0.1, 0.1, 6.7, 0.9, 1.5});
  writePyramidOfBalls(out);
  out.surface({{0.5, 0.45, 0.35}, 1, 0, 0, 0, 0});
  Mountain(out, size).write();
}

}  // namespace candela::generate

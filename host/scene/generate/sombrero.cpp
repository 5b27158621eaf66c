// sombrero: the ripples cos(2 pi r) exp(-r) as a height field of triangles (A. Enzmann).
#include <array>
#include <cmath>

#include "host/scene/generate/databases.h"

namespace candela::generate {
namespace {

constexpr double kMin = -4;  ///< minimum of x and z
constexpr double kExtent = 8;
constexpr double kGround = -3;  ///< y where the ripples have decayed

std::uint32_t pointsOnASide(std::uint32_t size) { return 16u << size; }

class Ripples {
 public:
  explicit Ripples(std::uint32_t points) : points_(points) {}

  glm::dvec3 vertex(std::uint32_t column, std::uint32_t row) const {
    return {kMin + column * spacing(), kGround + height(column, row), kMin + row * spacing()};
  }

 private:
  double spacing() const { return kExtent / (points_ - 1); }

  /// The database samples the ripples at spacings of extent / points, slightly denser than its vertices, and rounds
  /// heights to single precision.
  double height(std::uint32_t column, std::uint32_t row) const {
    constexpr double kTwoPi = 2 * 3.14159265358;
    const double radius = std::hypot(kMin + kExtent * column / points_, kMin + kExtent * row / points_);
    return static_cast<float>(std::cos(kTwoPi * radius) * std::exp(-radius));
  }

  std::uint32_t points_;
};

}  // namespace

std::uint64_t sombreroPrimitives(std::uint32_t size) {
  const std::uint64_t cells = pointsOnASide(size) - 1;
  return 2 * cells * cells;
}

void writeSombrero(NffWriter& out, std::uint32_t size) {
  out.background(kSkyBlue);
  out.view({{0, 5, -8}, {0, 0, 0}, {0, 0, 1}, 40, 0.01});
  out.light({10, 10, -10});
  out.surface({{1, 0.1, 0.1}, 0.8, 0, 40, 0, 1});
  const std::uint32_t points = pointsOnASide(size);
  const Ripples ripples(points);
  for (std::uint32_t row = 0; row + 1 < points; ++row) {
    for (std::uint32_t column = 0; column + 1 < points; ++column) {
      const glm::dvec3 corner = ripples.vertex(column, row);
      const glm::dvec3 opposite = ripples.vertex(column + 1, row + 1);
      out.polygon(std::array{corner, opposite, ripples.vertex(column + 1, row)});
      out.polygon(std::array{corner, ripples.vertex(column, row + 1), opposite});
    }
  }
}

}  // namespace candela::generate

// rings: a pyramid of balls, each made of six pentagonal rings that join the midpoints of a dodecahedron's edges, seen
// from its apex.
#include <array>
#include <cmath>
#include <numbers>

#include "host/scene/generate/databases.h"
#include "host/scene/generate/rotation.h"

namespace candela::generate {
namespace {

constexpr double kRingRadius = 0.07412;                     ///< radius of cylinders and spheres, such that rings touch
const double kSpread = 1 / std::sin(std::numbers::pi / 8);  ///< distance between layers, for a view of 45 degrees
const glm::dvec3 kEye(-1, -kSpread, 0.5);

using Pentagon = std::array<glm::dvec3, 5>;
using Rings = std::array<Pentagon, 6>;

/// The rings within the unit sphere: one in the xy plane, and its rotations into the planes of its neighbours.
Rings makeRings() {
  constexpr double kScale = 1 / (1 + kRingRadius);
  const double betweenFaces = 2 * std::acos(std::cos(std::numbers::pi / 3) / std::sin(std::numbers::pi / 5));
  const glm::dmat3 tilt = rotation(betweenFaces, {1, 0, 0});
  Rings rings;
  for (std::size_t i = 0; i < 5; ++i) {
    const double angle = static_cast<double>(i) * 2 * std::numbers::pi / 5;
    rings[0][i] = kScale * glm::dvec3(std::cos(angle), std::sin(angle), 0);
  }
  for (std::size_t ring = 1; ring < rings.size(); ++ring) {
    const glm::dmat3 turn = rotation(std::numbers::pi * (2 * static_cast<double>(ring) - 1) / 5, {0, 0, 1});
    for (std::size_t i = 0; i < 5; ++i) rings[ring][i] = turn * (tilt * rings[0][i]);
  }
  return rings;
}

void writeObject(NffWriter& out, const Rings& rings, const glm::dvec3& centre) {
  static constexpr std::array<glm::dvec3, 6> kColours{
      {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 1, 1}, {1, 0, 1}, {1, 1, 0}}};
  for (std::size_t ring = 0; ring < rings.size(); ++ring) {
    out.surface({kColours[ring], 0.5, 0.2, 37, 0, 0});
    for (std::size_t i = 0; i < 5; ++i) {
      const glm::dvec3 vertex = rings[ring][i] + centre;
      out.cone(vertex, kRingRadius, rings[ring][(i + 4) % 5] + centre, kRingRadius);
      out.sphere(vertex, kRingRadius);
    }
  }
}

/// Writes a wall behind the pyramid that is 1 % larger than the view.
void writeWall(NffWriter& out, std::uint32_t size) {
  const double y = kSpread * (size + 1);
  const double half = 1.01 * (y - kEye.y) * std::tan(std::numbers::pi / 8);
  const double x[] = {kEye.x - half, kEye.x + half};
  const double z[] = {kEye.z - half, kEye.z + half};
  out.surface({{1, 1, 1}, 1, 0, 0, 0, 0});
  out.polygon(std::array<glm::dvec3, 4>{{{x[1], y, z[1]}, {x[0], y, z[1]}, {x[0], y, z[0]}, {x[1], y, z[0]}}});
}

}  // namespace

std::uint64_t ringsPrimitives(std::uint32_t size) {
  const std::uint64_t s = size;
  return 10 * s * (s + 1) * (2 * s + 1) + 2;
}

void writeRings(NffWriter& out, std::uint32_t size) {
  out.background(kSkyBlue);
  out.view({kEye, kEye + glm::dvec3(0, 1, 0), {0, 0, 1}, 45, 1});
  out.light({3, -kSpread, 3});
  out.light({-4, -kSpread, 1});
  out.light({2, -kSpread, -4});
  writeWall(out, size);
  const Rings rings = makeRings();
  for (std::uint32_t layer = 0; layer < size; ++layer) {
    const auto place = [&](std::uint32_t i) { return 2.0 * i - layer; };
    for (std::uint32_t row = 0; row <= layer; ++row) {
      for (std::uint32_t column = 0; column <= layer; ++column) {
        writeObject(out, rings, {place(column), kSpread * (layer + 1), place(row)});
      }
    }
  }
}

}  // namespace candela::generate

// lattice: shiny balls at the points of a cubic lattice in the unit cube, each joined to its neighbours by matte bars
// (A. Costa).
#include <array>

#include "host/scene/generate/databases.h"

namespace candela::generate {
namespace {

constexpr double kBallFraction = 1.0 / 4;  ///< fraction of the distance between neighbours
constexpr double kBarFraction = 1.0 / 16;
/// A bar begins inside the ball, almost at the maximum depth.
constexpr double kBarStart = kBallFraction * 0.5 * 0.99;

constexpr Surface kBall{{0.9, 0.9, 0.9}, 0.5, 0.5, 37, 0, 0};
constexpr std::array<Surface, 3> kBars{
    {{{0.9, 0.1, 0.1}, 0.99, 0, 0, 0, 0}, {{0.1, 0.9, 0.1}, 0.99, 0, 0, 0, 0}, {{0.1, 0.1, 0.9}, 0.99, 0, 0, 0, 0}}};

void writePoint(NffWriter& out, const glm::uvec3& place, std::uint32_t size) {
  const double spacing = 1.0 / size;
  const glm::dvec3 centre = glm::dvec3(place) / static_cast<double>(size);
  out.surface(kBall);
  out.sphere(centre, kBallFraction * spacing);
  for (int axis = 0; axis < 3; ++axis) {
    if (place[axis] == size) continue;
    glm::dvec3 from = centre;
    glm::dvec3 to = centre;
    from[axis] += kBarStart * spacing;
    to[axis] += spacing - kBarStart * spacing;
    out.surface(kBars[static_cast<std::size_t>(axis)]);
    out.cone(from, kBarFraction * spacing, to, kBarFraction * spacing);
  }
}

}  // namespace

std::uint64_t latticePrimitives(std::uint32_t size) {
  const std::uint64_t points = std::uint64_t{size} + 1;
  return points * points * points + 3 * size * points * points;
}

void writeLattice(NffWriter& out, std::uint32_t size) {
  const double middle = (size / 2 + 0.5) / size;
  const double halfSpacing = 1.0 / (2 * size);
  out.background(kSkyBlue);
  out.view({{middle, 1, 1 - halfSpacing}, {middle, -1, -1 - halfSpacing}, {0.2, 1, 0}, 60, 0});
  for (int axis = 0; axis < 3; ++axis) {
    for (const double outside : {2.0, -1.0}) {
      glm::dvec3 light(0.5);
      light[axis] = outside;
      out.light(light);
    }
  }
  for (std::uint32_t x = 0; x <= size; ++x) {
    for (std::uint32_t y = 0; y <= size; ++y) {
      for (std::uint32_t z = 0; z <= size; ++z) writePoint(out, {x, y, z}, size);
    }
  }
}

}  // namespace candela::generate

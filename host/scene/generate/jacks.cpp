// jacks: a jack is three crossed bars with balls at their ends, and has a jack of half its size in each octant.
#include <array>
#include <glm/gtc/matrix_transform.hpp>

#include "host/scene/generate/databases.h"

namespace candela::generate {
namespace {

constexpr double
    kReach = 0.75;  ///< extent of a jack in its cube of half width 1, which keeps it clear of its neighbours

glm::dvec3 transformed(const glm::dmat4& place, const glm::dvec3& point) {
  return glm::dvec3(place * glm::dvec4(point, 1));
}

/// `place` has the scale `scale`.
void writeJack(NffWriter& out, const glm::dmat4& place, double scale) {
  static constexpr std::array<glm::dvec3, 3> kAxes{{{kReach, 0, 0}, {0, kReach, 0}, {0, 0, kReach}}};
  const double barRadius = 0.1 * kReach * scale;
  const double ballRadius = 0.2 * kReach * scale;
  for (const glm::dvec3& axis : kAxes) {
    out.cone(transformed(place, -axis), barRadius, transformed(place, axis), barRadius);
  }
  for (const glm::dvec3& axis : kAxes) out.sphere(transformed(place, axis), ballRadius);
  for (const glm::dvec3& axis : kAxes) out.sphere(transformed(place, -axis), ballRadius);
}

void writeJacksIn(NffWriter& out, const glm::dmat4& place, double scale, std::uint32_t levels) {
  writeJack(out, place, scale);
  if (levels == 1) return;
  for (int octant = 0; octant < 8; ++octant) {
    const glm::dvec3 middle(octant & 4 ? 0.5 : -0.5, octant & 2 ? 0.5 : -0.5, octant & 1 ? 0.5 : -0.5);
    const glm::dmat4 half = glm::scale(glm::translate(place, middle), glm::dvec3(0.5));
    writeJacksIn(out, half, scale / 2, levels - 1);
  }
}

}  // namespace

std::uint64_t jacksPrimitives(std::uint32_t size) {
  constexpr std::uint64_t kPrimitivesOfOne = 9;
  return kPrimitivesOfOne * ((std::uint64_t{1} << (3 * size)) - 1) / 7;
}

void writeJacks(NffWriter& out, std::uint32_t size) {
  out.background({0.2, 0.05, 0.2});
  out.view({{0, 0, -8}, {0, 0, 0}, {0, 1, 0}, 25, 0.001, 256, 256});
  out.light({-10, 3, -20});
  out.surface({{0.737, 0.561, 0.561}, 0.7, 0.7, 20, 0, 1});
  glm::dmat4 place = glm::rotate(glm::dmat4(1), glm::radians(-30.0), glm::dvec3(1, 0, 0));
  place = glm::rotate(place, glm::radians(-20.0), glm::dvec3(0, 1, 0));
  writeJacksIn(out, place, 1, size);
}

}  // namespace candela::generate

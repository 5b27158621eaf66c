// tree: a tree whose branches fork in two (Aono and Kunii, IEEE CG&A 4(5), 1984): cones, and spheres at their joints.
#include <array>
#include <glm/gtc/matrix_transform.hpp>

#include "host/scene/generate/databases.h"

namespace candela::generate {
namespace {

constexpr double kTaper = 0.67;          ///< ratio of the radius of a branch at its apex to that at its base
constexpr double kWidthToLength = 0.15;  ///< ratio of the width of the trunk to its length
constexpr std::size_t kBranches = 2;

using Growths = std::array<glm::dmat4, kBranches>;

/// Transforms a branch from the origin to +z into one that grows from its apex. Angles are in degrees.
glm::dmat4 growth(double branchingAngle, double divergence, double contraction) {
  glm::dmat4 transform = glm::translate(glm::dmat4(1), glm::dvec3(0, 0, 1));
  transform = glm::scale(transform, glm::dvec3(contraction));
  transform = glm::rotate(transform, glm::radians(divergence), glm::dvec3(0, 0, 1));
  return glm::rotate(transform, glm::radians(branchingAngle), glm::dvec3(1, 0, 0));
}

void writeBranch(NffWriter& out, const Growths& growths, const glm::dmat4& place, double scale,
                 std::uint32_t generationsLeft) {
  const glm::dvec3 base(place[3]);
  const glm::dvec3 apex(place * glm::dvec4(0, 0, 1, 1));
  const double radius = scale * kWidthToLength;
  out.cone(base, radius, apex, radius * kTaper);
  out.sphere(apex, radius * kTaper);
  if (generationsLeft == 0) return;
  for (const glm::dmat4& next : growths) writeBranch(out, growths, place * next, scale * kTaper, generationsLeft - 1);
}

}  // namespace

std::uint64_t treePrimitives(std::uint32_t size) { return 2 * ((std::uint64_t{2} << size) - 1) + 2; }

void writeTree(NffWriter& out, std::uint32_t size) {
  out.background(kSkyBlue);
  out.view({{4.5, 0.4, 2}, {0, 0, 1.5}, {0, 0, 1}, 45, 1});
  for (const glm::dvec3& light : std::array<glm::dvec3, 7>{
           {{-5, 5, 50}, {30, -30, 30}, {-40, -30, 20}, {10, 30, 40}, {-30, 40, 10}, {50, 25, 20}, {-10, -60, 30}}}) {
    out.light(light);
  }
  out.surface({{0.2, 0.7, 0.2}, 1, 0, 0, 0, 0});
  out.square(50, 0);
  out.surface({{0.55, 0.4, 0.2}, 1, 0, 0, 0, 0});
  writeBranch(out, {growth(40, 90, 0.65), growth(25, 230, 0.7)}, glm::dmat4(1), 1, size);
}

}  // namespace candela::generate

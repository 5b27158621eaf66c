// Exact bounds of each kind of primitive, and their padding.
#include "host/trace/accel/primitive_bounds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/base/errors.h"
#include "host/scene/shape.h"
#include "host/scene/stored_primitives.h"

namespace candela::accel {
namespace {

struct ExactBounds {
  glm::dvec3 min;
  glm::dvec3 max;
};

std::optional<ExactBounds> exactBounds(const scene::Sphere& sphere) {
  const glm::dvec3 centre(sphere.centre);
  const glm::dvec3 radius(std::abs(double{sphere.radius}));
  return ExactBounds{centre - radius, centre + radius};
}

std::optional<ExactBounds> exactBounds(const scene::Triangle& triangle) {
  const glm::dvec3 p0(triangle.p[0]), p1(triangle.p[1]), p2(triangle.p[2]);
  return ExactBounds{glm::min(p0, glm::min(p1, p2)), glm::max(p0, glm::max(p1, p2))};
}

std::optional<ExactBounds> exactBounds(const scene::Box& box) {
  return ExactBounds{glm::dvec3(box.min), glm::dvec3(box.max)};
}

// The convex hull of a truncated cone is that of its two circles. A circle of radius r around the unit axis w extends r
// sqrt(1 - w_i^2) along axis i. 1 - w_i^2 is computed as the sum of the other two squares, which does not cancel.
std::optional<ExactBounds> exactBounds(const scene::Cone& cone) {
  const glm::dvec3 base(cone.base), apex(cone.apex);
  const glm::dvec3 w = glm::normalize(apex - base);
  const glm::dvec3 reach = glm::sqrt(glm::dvec3(w.y * w.y + w.z * w.z, w.z * w.z + w.x * w.x, w.x * w.x + w.y * w.y));
  const glm::dvec3 atBase = reach * double{cone.baseRadius}, atApex = reach * double{cone.apexRadius};
  return ExactBounds{glm::min(base - atBase, apex - atApex), glm::max(base + atBase, apex + atApex)};
}

std::optional<ExactBounds> exactBounds(const scene::Plane&) { return std::nullopt; }

void padCoincident(const scene::StoredPrimitives& stored, const std::vector<bool>& coincident, float reach,
                   SceneBounds& scene) {
  if (coincident.empty()) return;
  for (std::size_t i = 0; i < scene.finite.size(); ++i) {
    if (coincident[stored.indexOf(scene.finite[i])]) reach = std::max(reach, largestCoordinate(scene.bounds[i]));
  }
  for (std::size_t i = 0; i < scene.finite.size(); ++i) {
    if (!coincident[stored.indexOf(scene.finite[i])]) continue;
    scene.bounds[i].min -= reach * kBoundsPad;
    scene.bounds[i].max += reach * kBoundsPad;
  }
  scene.coincidentReach = reach;
}

}  // namespace

Aabb paddedBounds(const glm::dvec3& min, const glm::dvec3& max) {
  const glm::dvec3 magnitudes = glm::max(glm::abs(min), glm::abs(max));
  const double pad = std::max({magnitudes.x, magnitudes.y, magnitudes.z}) * double{kBoundsPad};
  const auto upward = [&](double x) { return -roundDown(-(x + pad)); };
  return {{roundDown(min.x - pad), roundDown(min.y - pad), roundDown(min.z - pad)},
          {upward(max.x), upward(max.y), upward(max.z)}};
}

float largestCoordinate(const Aabb& box) {
  const glm::vec3 magnitudes = glm::max(glm::abs(box.min), glm::abs(box.max));
  return std::max({magnitudes.x, magnitudes.y, magnitudes.z});
}

std::optional<Aabb> primitiveBounds(const scene::Scene& scene, const scene::Primitive& primitive) {
  const auto exact = std::visit([](const auto& shape) { return exactBounds(shape); }, shapeOf(scene, primitive));
  if (!exact) return std::nullopt;
  const Aabb bounds = paddedBounds(exact->min, exact->max);
  const Aabb limits{glm::vec3(-kMaxCoordinate), glm::vec3(kMaxCoordinate)};
  if (!limits.contains(bounds)) {
    throw FileError(fmt::format("{}: a primitive reaches beyond {:.3g}, the largest coordinate that can be traced",
                                scene.name.empty() ? "scene" : scene.name, kMaxCoordinate));
  }
  return bounds;
}

SceneBounds boundPrimitives(const scene::Scene& scene, const std::vector<bool>& coincident,
                            const std::vector<bool>& leavesOut, float coincidentReach) {
  const std::span<const scene::PrimitiveRun> runs = scene.primitives.runs();
  SceneBounds result;
  std::size_t count = 0;
  for (std::size_t run = 0; run < runs.size(); ++run) {
    if (leavesOut.empty() || !leavesOut[run]) count += scene.primitives.countOf(runs[run]);
  }
  result.bounds.reserve(count);
  result.finite.reserve(count);
  for (std::size_t run = 0; run < runs.size(); ++run) {
    if (!leavesOut.empty() && leavesOut[run]) continue;
    const std::uint32_t end = runs[run].first + scene.primitives.countOf(runs[run]);
    for (std::uint32_t i = runs[run].first; i < end; ++i) {
      const std::optional<Aabb> bounds = primitiveBounds(scene, runs[run].at(i));
      if (bounds) {
        result.bounds.push_back(*bounds);
        result.finite.push_back(i);
      } else {
        result.infinite.push_back(i);
      }
    }
  }
  padCoincident(scene::StoredPrimitives(scene.primitives), coincident, coincidentReach, result);
  return result;
}

}  // namespace candela::accel

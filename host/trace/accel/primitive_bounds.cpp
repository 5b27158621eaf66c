// Exact bounds of each kind of primitive, and their padding.
#include "host/trace/accel/primitive_bounds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/base/errors.h"
#include "host/scene/shape.h"

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

Aabb padOutward(const ExactBounds& exact) {
  const glm::dvec3 magnitudes = glm::max(glm::abs(exact.min), glm::abs(exact.max));
  const double largest = std::max({magnitudes.x, magnitudes.y, magnitudes.z});
  const glm::dvec3 min = exact.min - largest * double{kBoundsPad};
  const glm::dvec3 max = exact.max + largest * double{kBoundsPad};
  return {{roundDown(min.x), roundDown(min.y), roundDown(min.z)},
          {-roundDown(-max.x), -roundDown(-max.y), -roundDown(-max.z)}};
}

float largestCoordinate(const Aabb& box) {
  const glm::vec3 magnitudes = glm::max(glm::abs(box.min), glm::abs(box.max));
  return std::max({magnitudes.x, magnitudes.y, magnitudes.z});
}

void padCoincident(const std::vector<bool>& coincident, SceneBounds& scene) {
  if (coincident.empty()) return;
  float reach = 0;
  for (std::size_t i = 0; i < scene.finite.size(); ++i) {
    if (coincident[scene.finite[i]]) reach = std::max(reach, largestCoordinate(scene.bounds[i]));
  }
  for (std::size_t i = 0; i < scene.finite.size(); ++i) {
    if (!coincident[scene.finite[i]]) continue;
    scene.bounds[i].min -= reach * kBoundsPad;
    scene.bounds[i].max += reach * kBoundsPad;
  }
}

}  // namespace

std::optional<Aabb> primitiveBounds(const scene::Scene& scene, const scene::Primitive& primitive) {
  const auto exact = std::visit([](const auto& shape) { return exactBounds(shape); }, shapeOf(scene, primitive));
  if (!exact) return std::nullopt;
  const Aabb bounds = padOutward(*exact);
  const Aabb limits{glm::vec3(-kMaxCoordinate), glm::vec3(kMaxCoordinate)};
  if (!limits.contains(bounds)) {
    throw FileError(fmt::format("{}: a primitive reaches beyond {:.3g}, the largest coordinate that can be traced",
                                scene.name.empty() ? "scene" : scene.name, kMaxCoordinate));
  }
  return bounds;
}

SceneBounds boundPrimitives(const scene::Scene& scene, const std::vector<bool>& coincident) {
  SceneBounds result;
  result.bounds.reserve(scene.primitives.size());
  result.finite.reserve(scene.primitives.size());
  for (std::uint32_t i = 0; i < scene.primitives.size(); ++i) {
    const std::optional<Aabb> bounds = primitiveBounds(scene, scene.primitives[i]);
    if (!bounds) {
      result.infinite.push_back(i);
      continue;
    }
    result.bounds.push_back(*bounds);
    result.finite.push_back(i);
  }
  padCoincident(coincident, result);
  return result;
}

}  // namespace candela::accel

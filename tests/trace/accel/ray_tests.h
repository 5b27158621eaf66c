// Intersections in single or double precision, in the forms that primitive_bounds.h calls free of cancellation, and
// the box test that it prescribes.
#pragma once
#include <cmath>
#include <optional>
#include <utility>

#include "host/scene/scene.h"
#include "host/trace/accel/primitive_bounds.h"

namespace candela::test {

using namespace accel;

template <class T>
using Vec = glm::vec<3, T>;

/// `direction` is of unit length.
template <class T>
struct Ray {
  Vec<T> origin;
  Vec<T> direction;
};

/// The nearer of the roots t0 <= t1 that is above 0.
template <class T>
std::optional<T> nearest(T t0, T t1) {
  if (t0 > 0) return t0;
  if (t1 > 0) return t1;
  return std::nullopt;
}

template <class T>
std::optional<T> intersect(const Ray<T>& ray, const scene::Sphere& sphere) {
  const T radius = sphere.radius;
  const Vec<T> toOrigin = ray.origin - Vec<T>(sphere.centre);
  const T closest = -glm::dot(toOrigin, ray.direction);
  const Vec<T> miss = toOrigin + closest * ray.direction;
  const T halfChord2 = radius * radius - glm::dot(miss, miss);
  if (halfChord2 < 0) return std::nullopt;
  return nearest(closest - std::sqrt(halfChord2), closest + std::sqrt(halfChord2));
}

/// Woop, Benthin and Wald, Watertight Ray/Triangle Intersection, JCGT 2013.
template <class T>
std::optional<T> intersect(const Ray<T>& ray, const scene::Triangle& triangle) {
  const Vec<T> d = ray.direction, size = glm::abs(d);
  const int z = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
  const int x = (z + 1) % 3, y = (z + 2) % 3;
  const T shearX = d[x] / d[z], shearY = d[y] / d[z], shearZ = 1 / d[z];
  Vec<T> px, py, pz;
  for (int i = 0; i < 3; ++i) {
    const Vec<T> p = Vec<T>(triangle.p[i]) - ray.origin;
    px[i] = p[x] - shearX * p[z];
    py[i] = p[y] - shearY * p[z];
    pz[i] = shearZ * p[z];
  }
  const Vec<T> weights(px[2] * py[1] - py[2] * px[1], px[0] * py[2] - py[0] * px[2], px[1] * py[0] - py[1] * px[0]);
  const bool someNegative = weights.x < 0 || weights.y < 0 || weights.z < 0;
  const bool somePositive = weights.x > 0 || weights.y > 0 || weights.z > 0;
  if (someNegative == somePositive) return std::nullopt;
  const T t = glm::dot(weights, pz) / (weights.x + weights.y + weights.z);
  return t > 0 ? std::optional(t) : std::nullopt;
}

template <class T>
std::optional<T> intersect(const Ray<T>& ray, const scene::Box& box) {
  T enter = -std::numeric_limits<T>::infinity(), leave = -enter;
  for (int i = 0; i < 3; ++i) {
    const T below = T{box.min[i]} - ray.origin[i], above = T{box.max[i]} - ray.origin[i];
    if (ray.direction[i] == 0) {
      if (below > 0 || above < 0) return std::nullopt;
      continue;
    }
    const T t0 = below / ray.direction[i], t1 = above / ray.direction[i];
    enter = std::max(enter, std::min(t0, t1));
    leave = std::min(leave, std::max(t0, t1));
  }
  if (enter > leave) return std::nullopt;
  return nearest(enter, leave);
}

/// The origin is first moved to where the ray is closest to the axis' middle, and from there to where it is closest to
/// the axis, but no farther than a hit can be: long thin cones need both.
template <class T>
std::optional<T> intersect(const Ray<T>& ray, const scene::Cone& cone) {
  const Vec<T> base(cone.base), axis = Vec<T>(cone.apex) - base;
  const T height = glm::length(axis), slope = (T{cone.apexRadius} - T{cone.baseRadius}) / height;
  const Vec<T> w = axis / height;
  const T toMiddle = -glm::dot(ray.origin - (base + axis / T{2}), ray.direction);
  const Vec<T> xMiddle = (ray.origin - base) + toMiddle * ray.direction;
  const T dz = glm::dot(ray.direction, w), reach = height + T{cone.baseRadius} + T{cone.apexRadius};
  const Vec<T> dAcross = ray.direction - dz * w;
  const T toAxis = -glm::dot(xMiddle - glm::dot(xMiddle, w) * w, dAcross) / glm::dot(dAcross, dAcross);
  const T onward = std::isfinite(toAxis) ? std::clamp(toAxis, -reach, reach) : 0, moved = toMiddle + onward;
  const Vec<T> x = xMiddle + onward * ray.direction;
  const T z = glm::dot(x, w), radius = T{cone.baseRadius} + slope * z;
  const Vec<T> xAcross = x - z * w;
  const T a = glm::dot(dAcross, dAcross) - slope * dz * slope * dz;
  const T b = glm::dot(xAcross, dAcross) - radius * slope * dz;
  const T c = glm::dot(xAcross, xAcross) - radius * radius;
  const T discriminant = b * b - a * c;
  if (discriminant < 0) return std::nullopt;
  const T q = -(b + std::copysign(std::sqrt(discriminant), b));
  std::optional<T> best;
  for (const T root : {q / a, c / q}) {
    const T hitZ = z + root * dz, t = root + moved;
    if (!(hitZ >= 0 && hitZ <= height && t > 0)) continue;
    if (T{cone.baseRadius} + slope * hitZ < 0) continue;
    if (!best || t < *best) best = t;
  }
  return best;
}

template <class T>
std::optional<T> intersect(const Ray<T>& ray, const scene::Scene& scene, const scene::Primitive& primitive) {
  switch (primitive.kind) {
    case scene::PrimitiveKind::sphere:
      return intersect(ray, scene.spheres[primitive.index]);
    case scene::PrimitiveKind::triangle:
      return intersect(ray, triangleOf(scene, primitive));
    case scene::PrimitiveKind::box:
      return intersect(ray, scene.boxes[primitive.index]);
    case scene::PrimitiveKind::cone:
      return intersect(ray, scene.cones[primitive.index]);
    case scene::PrimitiveKind::plane:
      break;
  }
  return std::nullopt;
}

/// Values that are precomputed per ray for the box test.
template <class T>
struct SlabRay {
  static constexpr T kEndless = std::numeric_limits<T>::infinity();
  Vec<T> originForMin;
  Vec<T> originForMax;
  Vec<T> inverse;

  explicit SlabRay(const Ray<T>& ray) {
    const Vec<T> size = glm::abs(ray.origin);
    const Vec<T> pad(T{accel::kBoundsPad} * std::max({size.x, size.y, size.z}));
    originForMin = ray.origin + pad;
    originForMax = ray.origin - pad;
    for (int i = 0; i < 3; ++i) {
      const T d = ray.direction[i];
      inverse[i] = 1 / (std::abs(d) < T{0x1p-100f} ? std::copysign(T{0x1p-100f}, d) : d);
    }
  }

  /// Returns the distance at which the ray enters the box (0 if it starts inside), if it is at most `farthest`.
  std::optional<T> enter(const Aabb& box, T farthest) const {
    const Vec<T> t0 = (Vec<T>(box.min) - originForMin) * inverse, t1 = (Vec<T>(box.max) - originForMax) * inverse;
    const Vec<T> first = glm::min(t0, t1), last = glm::max(t0, t1);
    const T near = std::max({first.x, first.y, first.z, T{0}}), far = std::min({last.x, last.y, last.z, farthest});
    return near <= far ? std::optional(near) : std::nullopt;
  }
};

}  // namespace candela::test

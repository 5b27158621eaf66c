// Tests all primitives of a scene one after the other.
#include "tests/scene/generate/emitters.h"

#include <algorithm>
#include <numbers>

#include "host/scene/coincidence/coincidence.h"

namespace candela {
namespace {

using glm::dvec3;

bool crossesBox(const scene::Box& box, const dvec3& a, const dvec3& b) {
  double from = 0, to = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const double step = b[axis] - a[axis];
    if (step == 0) {
      if (a[axis] < box.min[axis] || a[axis] > box.max[axis]) return false;
      continue;
    }
    const double first = (box.min[axis] - a[axis]) / step, second = (box.max[axis] - a[axis]) / step;
    from = std::max(from, std::min(first, second));
    to = std::min(to, std::max(first, second));
  }
  return from <= to;
}

bool crossesSphere(const scene::Sphere& sphere, const dvec3& a, const dvec3& b) {
  const dvec3 step = b - a, centre(sphere.centre);
  const double t = std::clamp(dot(centre - a, step) / dot(step, step), 0.0, 1.0);
  return length(a + t * step - centre) <= sphere.radius;
}

bool crossesTriangle(const scene::Triangle& triangle, const dvec3& a, const dvec3& b) {
  const dvec3 p(triangle.p[0]), e1 = dvec3(triangle.p[1]) - p, e2 = dvec3(triangle.p[2]) - p, step = b - a;
  const dvec3 h = cross(step, e2);
  const double determinant = dot(e1, h);
  if (determinant == 0) return false;
  const dvec3 s = a - p, q = cross(s, e1);
  const double u = dot(s, h) / determinant, v = dot(step, q) / determinant, t = dot(e2, q) / determinant;
  return u >= 0 && v >= 0 && u + v <= 1 && t >= 0 && t <= 1;
}

}  // namespace

double Emitter::power() const {
  return (radiance.x + radiance.y + radiance.z) / 3 * std::numbers::pi * area * (isSphere ? 1 : 2);
}

std::vector<Emitter> emittersOf(const scene::Scene& scene) {
  std::vector<Emitter> emitters;
  std::uint32_t index = 0;
  for (const scene::Primitive& primitive : scene.primitives) {
    const scene::Material& material = scene.materials[primitive.material];
    const std::uint32_t own = index++;
    if (!isEmissive(material)) continue;
    const dvec3 radiance(material.emission);
    if (primitive.kind == scene::PrimitiveKind::sphere) {
      const scene::Sphere& sphere = scene.spheres[primitive.index];
      const double area = 4 * std::numbers::pi * sphere.radius * sphere.radius;
      emitters.push_back({own, true, dvec3(sphere.centre), dvec3(0), area, radiance});
    } else if (primitive.kind == scene::PrimitiveKind::triangle) {
      const scene::Triangle triangle = triangleOf(scene, primitive);
      const dvec3 a(triangle.p[0]), b(triangle.p[1]), c(triangle.p[2]), normal = cross(b - a, c - a);
      emitters.push_back({own, false, (a + b + c) / 3.0, normalize(normal), length(normal) / 2, radiance});
    }
  }
  return emitters;
}

std::vector<dvec3> pointsBefore(const scene::Scene& scene, const Emitter& emitter) {
  constexpr double kDistance = 1e-4;
  const scene::Primitive primitive = scene.primitives[emitter.primitive];
  std::vector<dvec3> points;
  if (emitter.isSphere) {
    const double radius = scene.spheres[primitive.index].radius + kDistance;
    for (int axis = 0; axis < 3; ++axis) {
      dvec3 offset(0);
      offset[axis] = radius;
      points.insert(points.end(), {emitter.centre + offset, emitter.centre - offset});
    }
    return points;
  }
  points.push_back(emitter.centre + kDistance * emitter.normal);
  for (const glm::vec3& corner : triangleOf(scene, primitive).p) {
    points.push_back(mix(dvec3(corner), emitter.centre, 0.01) + kDistance * emitter.normal);
  }
  return points;
}

bool isObstructed(const scene::Scene& scene, const dvec3& a, const dvec3& b) {
  return std::ranges::any_of(scene.primitives, [&](const scene::Primitive& primitive) {
    if (isEmissive(scene.materials[primitive.material])) return false;
    switch (primitive.kind) {
      case scene::PrimitiveKind::box:
        return crossesBox(scene.boxes[primitive.index], a, b);
      case scene::PrimitiveKind::sphere:
        return crossesSphere(scene.spheres[primitive.index], a, b);
      case scene::PrimitiveKind::triangle:
        return crossesTriangle(triangleOf(scene, primitive), a, b);
      default:
        return false;
    }
  });
}

std::size_t coincidentCount(const scene::Scene& scene) {
  const scene::Coincidences found = scene::findCoincidences(scene);
  return static_cast<std::size_t>(std::ranges::count(found.coincident, true)) + found.copiedRuns.size();
}

}  // namespace candela

// Compares every light with every primitive, within a bound on the number of comparisons.
#include "host/trace/flatten/touched_primitives.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/scene/shape.h"
#include "host/scene/stored_primitives.h"
#include "host/trace/flatten/overlap.h"

namespace candela::flatten {
namespace {

using glm::dvec3;

constexpr double kTwiceTheMargin = 0x1p-18;
constexpr double kMaxComparisons = 0x1p25;  // about a quarter of a second

double largest(const dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

// Returns the tolerance for a surface whose largest coordinate is `reach`.
double tolerance(const dvec3& point, double reach, double slack) {
  return kTwiceTheMargin * std::max(largest(point), reach) + slack;
}

struct FlatShape {
  std::vector<dvec3> corners;  // none: infinite
  dvec3 at;
  dvec3 normal;  // of any length
  double reach;

  bool holds(const dvec3& point, double slack) const {
    const dvec3 size = glm::abs(normal);
    return std::abs(dot(normal, point - at)) <= tolerance(point, reach, slack) * (size.x + size.y + size.z);
  }
};

FlatShape triangleShape(const scene::Triangle& triangle) {
  const dvec3 a(triangle.p[0]), b(triangle.p[1]), c(triangle.p[2]);
  return {{a, b, c}, a, cross(b - a, c - a), std::max({largest(a), largest(b), largest(c)})};
}

FlatShape planeShape(const scene::Plane& plane) {
  const dvec3 a(plane.p[0]), b(plane.p[1]), c(plane.p[2]);
  return {{}, a, cross(b - a, c - a), largest(a)};
}

// The face of a box on the lower or the upper side of an axis.
FlatShape faceShape(const scene::Box& box, int axis, bool upper) {
  const dvec3 low(box.min), high(box.max);
  FlatShape face{{}, upper ? high : low, dvec3(0), std::max(largest(low), largest(high))};
  face.normal[axis] = 1;
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  for (const auto& [atU, atV] : {std::pair{low[u], low[v]}, {high[u], low[v]}, {high[u], high[v]}, {low[u], high[v]}}) {
    dvec3 corner = face.at;
    corner[u] = atU;
    corner[v] = atV;
    face.corners.push_back(corner);
  }
  return face;
}

// The flat parts of a shape; none of a curved one.
struct FlatParts {
  using Result = std::vector<FlatShape>;

  Result operator()(const scene::Triangle& triangle) const { return {triangleShape(triangle)}; }
  Result operator()(const scene::Plane& plane) const { return {planeShape(plane)}; }
  Result operator()(const scene::Box& box) const {
    Result faces;
    for (int face = 0; face < 6; ++face) faces.push_back(faceShape(box, face / 2, face % 2 != 0));
    return faces;
  }
  Result operator()(const scene::Sphere&) const { return {}; }
  Result operator()(const scene::Cone&) const { return {}; }
};

// Returns whether a curved shape contains the point.
bool curveHolds(const scene::Sphere& sphere, const dvec3& point, double slack) {
  const dvec3 centre(sphere.centre);
  const double radius = std::abs(double{sphere.radius});
  const double allowed = tolerance(point, largest(centre) + radius, slack);
  return std::abs(length(point - centre) - radius) <= allowed;
}

bool curveHolds(const scene::Cone& cone, const dvec3& point, double slack) {
  const dvec3 base(cone.base), apex(cone.apex);
  const double height = length(apex - base);
  const dvec3 axis = (apex - base) / height;
  const double slope = (double{cone.apexRadius} - cone.baseRadius) / height;
  const double z = dot(point - base, axis);
  const double off = length(point - base - z * axis) - (cone.baseRadius + slope * z);
  const double reach = std::max(largest(base) + cone.baseRadius, largest(apex) + cone.apexRadius);
  return std::abs(off) <= tolerance(point, reach, slack) * std::sqrt(1 + slope * slope);
}

bool curveHolds(const scene::Triangle&, const dvec3&, double) { return false; }
bool curveHolds(const scene::Box&, const dvec3&, double) { return false; }
bool curveHolds(const scene::Plane&, const dvec3&, double) { return false; }

bool curveHolds(const scene::Shape& shape, const dvec3& point, double slack) {
  return std::visit([&](const auto& curve) { return curveHolds(curve, point, slack); }, shape);
}

bool holdsPoint(const scene::Shape& shape, const std::vector<FlatShape>& parts, const LightPositions& lights) {
  return std::any_of(lights.points.begin(), lights.points.end(), [&](const dvec3& point) {
    const auto holds = [&](const FlatShape& part) { return part.holds(point, lights.slack); };
    return std::any_of(parts.begin(), parts.end(), holds) || curveHolds(shape, point, lights.slack);
  });
}

bool holdsTriangle(const FlatShape& shape, const EmitterPosition& emitter) {
  const auto holds = [&](const dvec3& vertex) { return shape.holds(vertex, 0); };
  if (!std::all_of(emitter.vertices.begin(), emitter.vertices.end(), holds)) return false;
  return shape.corners.empty() || overlap(shape.corners, emitter.vertices, shape.normal);
}

bool holdsTriangle(const scene::Shape& shape, std::uint32_t primitive, const std::vector<FlatShape>& parts,
                   const LightPositions& lights) {
  return std::any_of(lights.triangles.begin(), lights.triangles.end(), [&](const EmitterPosition& emitter) {
    if (emitter.primitive == primitive) return false;
    const auto flat = [&](const FlatShape& part) { return holdsTriangle(part, emitter); };
    const auto curved = [&](const dvec3& vertex) { return curveHolds(shape, vertex, 0); };
    return std::any_of(parts.begin(), parts.end(), flat) ||
           std::all_of(emitter.vertices.begin(), emitter.vertices.end(), curved);
  });
}

}  // namespace

LightPositions lightPositions(const scene::Scene& scene, std::span<const LightEntry> table,
                              const render::ImageSettings& image) {
  LightPositions positions;
  if (render::isView(image.integrator)) return positions;
  if (image.integrator == render::Integrator::whitted) {
    for (const scene::PointLight& light : scene.pointLights) positions.points.emplace_back(light.position);
    positions.slack = double{image.lightSize} / std::numbers::sqrt2;
    return positions;
  }
  for (const LightEntry& entry : table) {
    if (entry.kind == LightKind::point) positions.points.emplace_back(scene.pointLights[entry.index].position);
    if (entry.kind == LightKind::punctual || entry.kind == LightKind::spot)
      positions.points.emplace_back(scene.punctualLights[entry.index].position);
    if (entry.kind != LightKind::triangle) continue;
    const scene::PrimitiveRun& run = scene.primitives.runOf(entry.index);
    const std::uint32_t end = entry.index + (entry.isInstance() ? scene.primitives.countOf(run) : 1);
    for (std::uint32_t i = entry.index; i < end; ++i) {
      const scene::Triangle triangle = triangleOf(scene, run.at(i));
      positions.triangles.push_back({i, {dvec3(triangle.p[0]), dvec3(triangle.p[1]), dvec3(triangle.p[2])}});
    }
  }
  return positions;
}

std::vector<bool> touchedPrimitives(const scene::Scene& scene, const LightPositions& lights) {
  const std::size_t lightCount = lights.points.size() + lights.triangles.size();
  const double comparisons = static_cast<double>(lightCount) * static_cast<double>(scene.primitives.size());
  const scene::StoredPrimitives stored(scene.primitives);
  std::vector<bool> touched(stored.count(), comparisons > kMaxComparisons);
  if (lightCount == 0 || comparisons > kMaxComparisons) return touched;
  for (std::uint32_t i = 0; i < scene.primitives.size(); ++i) {
    const scene::Shape shape = shapeOf(scene, scene.primitives[i]);
    const std::vector<FlatShape> parts = std::visit(FlatParts(), shape);
    if (holdsPoint(shape, parts, lights) || holdsTriangle(shape, i, parts, lights)) touched[stored.indexOf(i)] = true;
  }
  return touched;
}

}  // namespace candela::flatten

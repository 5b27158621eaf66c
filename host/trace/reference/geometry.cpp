// Pluecker's test of edges for triangles, slabs for boxes.
#include "host/trace/reference/geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "host/scene/coincidence/coincidence.h"
#include "host/scene/shape.h"

namespace candela::reference {
namespace {

// Returns six times the signed volume that a ray's direction spans with both ends of an edge, as seen from the ray's
// origin. Its sign is the side of the edge on which the ray passes (Pluecker's inner product). For the reversed edge,
// the result is exactly the negative. Two triangles that share an edge thus use the same number for it, and no ray
// passes between them.
double sideOfEdge(const dvec3& direction, const dvec3& from, const dvec3& to) {
  return dot(direction, cross(from, to));
}

struct Prepare {
  Shape operator()(const scene::Sphere& sphere) const { return SphereShape(sphere); }
  Shape operator()(const scene::Triangle& triangle) const { return TriangleShape(triangle); }
  Shape operator()(const scene::Box& box) const { return BoxShape(box); }
  Shape operator()(const scene::Cone& cone) const { return ConeShape(scene::withSortedEnds(cone)); }
  Shape operator()(const scene::Plane& plane) const { return PlaneShape(plane); }
};

// Returns whether a ray that stays on its side starts in the plane of another primitive than its origin's. Rounding has
// moved its origin to either side of the plane, so that the ray may seem to hit it at a distance that should be 0.
bool startsInPlane(const Ray& ray, const dvec3& point, const dvec3& normal) {
  constexpr double kRounding = 0x1p-40;  // of coordinates, for hits that are far from the origins of their rays
  if (ray.originPrimitive == kNoPrimitive || ray.crosses) return false;
  const double coordinates = std::max(maxNorm(point), maxNorm(ray.origin));
  return std::abs(dot(point - ray.origin, normal)) <= kRounding * coordinates * maxNorm(normal);
}

bool isLess(const dvec3& a, const dvec3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); }

// Returns the normal of the triangle with its vertices in lexicographical order, so that no order of them rounds it
// differently.
dvec3 normalOfSorted(std::array<dvec3, 3> corners) {
  std::ranges::sort(corners, isLess);
  return cross(corners[1] - corners[0], corners[2] - corners[0]);
}

}  // namespace

TriangleShape::TriangleShape(const scene::Triangle& triangle)
    : corner(triangle.p[0]),
      corner1(triangle.p[1]),
      corner2(triangle.p[2]),
      edge1(corner1 - corner),
      edge2(corner2 - corner),
      sortedNormal_(normalOfSorted({corner, corner1, corner2})) {}

double TriangleShape::distance(const Ray& ray) const {
  const double t = lineDistance(ray);
  return startsInPlane(ray, corner, sortedNormal_) ? kNoHit : positiveOrNoHit(t);
}

double TriangleShape::lineDistance(const Ray& ray) const {
  const dvec3 a = corner - ray.origin;
  const dvec3 b = corner1 - ray.origin;
  const dvec3 c = corner2 - ray.origin;
  const auto [min, max] = std::minmax(
      {sideOfEdge(ray.direction, a, b), sideOfEdge(ray.direction, b, c), sideOfEdge(ray.direction, c, a)});
  if (min < 0 && max > 0) return kNoHit;
  const double towards = dot(ray.direction, sortedNormal_);
  if (towards == 0) return kNoHit;
  // The vertex that comes first in lexicographical order stands for the plane.
  return dot(std::min({a, b, c}, isLess), sortedNormal_) / towards;
}

dvec2 TriangleShape::barycentrics(const Ray& ray) const {
  const dvec3 p = cross(ray.direction, edge2);
  const dvec3 s = ray.origin - corner;
  return dvec2(dot(s, p), dot(ray.direction, cross(s, edge1))) / dot(edge1, p);
}

// ---------------------------------------------------------------------------------------------------------------------

BoxShape::BoxShape(const scene::Box& box) : min(box.min), max(box.max) {}

BoxShape::Crossings BoxShape::crossings(const Ray& ray) const {
  Crossings result;
  for (int axis = 0; axis < 3; ++axis) {
    const double o = ray.origin[axis];
    const double d = ray.direction[axis];
    if (d == 0) {
      if (o < min[axis] || o > max[axis]) return {kNoHit, -kNoHit, axis, axis};
      continue;
    }
    const double t1 = ((d > 0 ? min : max)[axis] - o) / d;
    const double t2 = ((d > 0 ? max : min)[axis] - o) / d;
    if (t1 > result.entry) result.entry = t1, result.entryAxis = axis;
    if (t2 < result.exit) result.exit = t2, result.exitAxis = axis;
  }
  return result;
}

dvec3 BoxShape::Crossings::entryNormal(const Ray& ray) const {
  dvec3 normal(0);
  normal[entryAxis] = std::copysign(1.0, -ray.direction[entryAxis]);
  return normal;
}

dvec3 BoxShape::Crossings::exitNormal(const Ray& ray) const {
  dvec3 normal(0);
  normal[exitAxis] = std::copysign(1.0, ray.direction[exitAxis]);
  return normal;
}

double BoxShape::distance(const Ray& ray, bool startsHere) const {
  if (startsHere && !(dot(ray.direction, ray.originNormal) < 0)) return kNoHit;
  const Crossings line = crossings(ray);
  if (startsHere) return positiveOrNoHit(line.exit);
  if (line.misses()) return kNoHit;
  return positiveOrNoHit(line.entry > 0 ? line.entry : line.exit);
}

dvec3 BoxShape::normal(const Ray& ray, double distance, bool startsHere) const {
  const Crossings line = crossings(ray);
  const bool entered = !startsHere && std::abs(distance - line.entry) <= std::abs(distance - line.exit);
  return entered ? line.entryNormal(ray) : line.exitNormal(ray);
}

// ---------------------------------------------------------------------------------------------------------------------

PlaneShape::PlaneShape(const scene::Plane& plane)
    : point(plane.p[0]), unitNormal(normalize(cross(dvec3(plane.p[1]) - point, dvec3(plane.p[2]) - point))) {}

double PlaneShape::distance(const Ray& ray) const {
  return startsInPlane(ray, point, unitNormal) ? kNoHit : positiveOrNoHit(lineDistance(ray));
}

double PlaneShape::lineDistance(const Ray& ray) const {
  const double towards = dot(ray.direction, unitNormal);
  return towards == 0 ? kNoHit : dot(point - ray.origin, unitNormal) / towards;
}

// ---------------------------------------------------------------------------------------------------------------------

bool isEverHit(const Shape& shape) {
  const auto* triangle = std::get_if<TriangleShape>(&shape);
  return triangle == nullptr || triangle->areaNormal() != dvec3(0);
}

Shape preparedShape(const scene::Scene& scene, const scene::Primitive& primitive) {
  return std::visit(Prepare(), scene::shapeOf(scene, primitive));
}

}  // namespace candela::reference

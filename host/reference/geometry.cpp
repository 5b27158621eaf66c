// Pluecker's test of edges for triangles, slabs for boxes.
#include "host/reference/geometry.h"

#include <algorithm>
#include <cmath>

#include "host/reference/rounding.h"
#include "host/scene/shape.h"

namespace candela::reference {
namespace {

// Returns whether a ray starts on another primitive in the plane of this one. Rounding has moved its origin to either
// side of the plane, so that the ray may seem to hit it at a distance that should be 0.
bool startsInPlane(const Ray& ray, const dvec3& point, const dvec3& normal) {
  constexpr double kRounding = 0x1p-40;  // of coordinates, for hits that are far from the origins of their rays
  if (ray.originPrimitive == kNoPrimitive) return false;
  const double coordinates = std::max(maxNorm(point), maxNorm(ray.origin));
  return std::abs(dot(point - ray.origin, normal)) <= kRounding * coordinates * maxNorm(normal);
}

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
  Shape operator()(const scene::Cone& cone) const { return ConeShape(cone); }
  Shape operator()(const scene::Plane& plane) const { return PlaneShape(plane); }
};

}  // namespace

TriangleShape::TriangleShape(const scene::Triangle& triangle)
    : corner(triangle.p[0]),
      corner1(triangle.p[1]),
      corner2(triangle.p[2]),
      edge1(corner1 - corner),
      edge2(corner2 - corner) {}

double TriangleShape::distance(const Ray& ray) const {
  const dvec3 a = corner - ray.origin;
  const dvec3 b = corner1 - ray.origin;
  const dvec3 c = corner2 - ray.origin;
  const auto [min, max] = std::minmax(
      {sideOfEdge(ray.direction, a, b), sideOfEdge(ray.direction, b, c), sideOfEdge(ray.direction, c, a)});
  if (min < 0 && max > 0) return kNoHit;
  const dvec3 normal = areaNormal();
  const double towards = dot(ray.direction, normal);
  if (towards == 0 || startsInPlane(ray, corner, normal)) return kNoHit;
  return positiveOrNoHit(dot(a, normal) / towards);
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

double BoxShape::distance(const Ray& ray, bool startsHere) const {
  if (startsHere && !(dot(ray.direction, ray.originNormal) < 0)) return kNoHit;
  const auto [entry, exit, entryAxis, exitAxis] = crossings(ray);
  if (startsHere) return positiveOrNoHit(exit);
  if (entry > exit) return kNoHit;
  return positiveOrNoHit(entry > 0 ? entry : exit);
}

dvec3 BoxShape::normal(const Ray& ray, bool startsHere) const {
  const auto [entry, exit, entryAxis, exitAxis] = crossings(ray);
  const bool entered = !startsHere && entry > 0;
  const int axis = entered ? entryAxis : exitAxis;
  dvec3 result(0);
  result[axis] = std::copysign(1.0, entered ? -ray.direction[axis] : ray.direction[axis]);
  return result;
}

// ---------------------------------------------------------------------------------------------------------------------

PlaneShape::PlaneShape(const scene::Plane& plane)
    : point(plane.p[0]), unitNormal(normalize(cross(dvec3(plane.p[1]) - point, dvec3(plane.p[2]) - point))) {}

double PlaneShape::distance(const Ray& ray) const {
  const double towards = dot(ray.direction, unitNormal);
  if (towards == 0 || startsInPlane(ray, point, unitNormal)) return kNoHit;
  return positiveOrNoHit(dot(point - ray.origin, unitNormal) / towards);
}

// ---------------------------------------------------------------------------------------------------------------------

Shape preparedShape(const scene::Scene& scene, const scene::Primitive& primitive) {
  return std::visit(Prepare(), scene::shapeOf(scene, primitive));
}

}  // namespace candela::reference

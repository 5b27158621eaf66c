// Compares planes by the vertices of the surfaces in them, and curved surfaces by their parameters.
#include "host/trace/reference/coincidence.h"

#include <algorithm>
#include <cmath>

namespace candela::reference {
namespace {

double largestCoordinate(const FlatSurface& surface) {
  dvec3 largest = abs(surface.point);
  for (std::size_t i = 0; i < surface.cornerCount; ++i) largest = max(largest, abs(surface.corners[i]));
  return std::max({largest.x, largest.y, largest.z});
}

// Returns whether the vertices of a surface are this close to the plane of another one.
bool isWithin(const FlatSurface& surface, const FlatSurface& plane, double tolerance) {
  return surface.cornerCount > 0 &&
         std::all_of(
             surface.corners.begin(), surface.corners.begin() + static_cast<std::ptrdiff_t>(surface.cornerCount),
             [&](const dvec3& corner) { return std::abs(dot(corner - plane.point, plane.normal)) <= tolerance; });
}

struct Coincide {
  const Shape& other;

  template <class Body>
  bool operator()(const Body& body) const {
    return isSame(other, body);
  }
  bool operator()(const TriangleShape& triangle) const { return isCoplanar(FlatSurface(triangle)); }
  bool operator()(const PlaneShape& plane) const { return isCoplanar(FlatSurface(plane)); }

  bool isCoplanar(const FlatSurface& surface) const {
    if (const auto* triangle = std::get_if<TriangleShape>(&other)) return areCoplanar(surface, FlatSurface(*triangle));
    if (const auto* plane = std::get_if<PlaneShape>(&other)) return areCoplanar(surface, FlatSurface(*plane));
    return false;
  }
};

struct FlatOrigin {
  const Ray& ray;

  std::optional<FlatSurface> operator()(const TriangleShape& triangle) const { return FlatSurface(triangle); }
  std::optional<FlatSurface> operator()(const PlaneShape& plane) const { return FlatSurface(plane); }
  std::optional<FlatSurface> operator()(const BoxShape& box) const { return FlatSurface(box, ray.originNormal); }
  std::optional<FlatSurface> operator()(const SphereShape&) const { return std::nullopt; }
  std::optional<FlatSurface> operator()(const ConeShape&) const { return std::nullopt; }
};

}  // namespace

FlatSurface::FlatSurface(const TriangleShape& triangle)
    : corners{triangle.corner, triangle.corner1, triangle.corner2},
      cornerCount(3),
      point(triangle.corner),
      normal(normalize(triangle.areaNormal())) {}

FlatSurface::FlatSurface(const PlaneShape& plane)
    : corners{}, cornerCount(0), point(plane.point), normal(plane.unitNormal) {}

FlatSurface::FlatSurface(const BoxShape& box, const dvec3& outward) : cornerCount(4), normal(round(outward)) {
  const bool isUpper = normal.x + normal.y + normal.z > 0;
  const int axis = normal.x != 0 ? 0 : normal.y != 0 ? 1 : 2;
  point = isUpper ? box.max : box.min;
  corners.fill(point);
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  for (std::size_t i = 0; i < 4; ++i) {
    corners[i][u] = (i % 2 == 0 ? box.min : box.max)[u];
    corners[i][v] = (i / 2 == 0 ? box.min : box.max)[v];
  }
}

bool areCoplanar(const FlatSurface& a, const FlatSurface& b) {
  const double tolerance = kCoplanar * std::max(largestCoordinate(a), largestCoordinate(b));
  if (a.cornerCount > 0 || b.cornerCount > 0) return isWithin(a, b, tolerance) || isWithin(b, a, tolerance);
  return length(cross(a.normal, b.normal)) <= kCoplanar && std::abs(dot(a.point - b.point, b.normal)) <= tolerance;
}

std::optional<FlatSurface> flatOrigin(const Shape& shape, const Ray& ray) { return std::visit(FlatOrigin{ray}, shape); }

bool isSame(const Shape& shape, const SphereShape& sphere) {
  const auto* other = std::get_if<SphereShape>(&shape);
  return other && other->centre == sphere.centre && std::abs(other->radius) == std::abs(sphere.radius);
}

bool isSame(const Shape& shape, const ConeShape& cone) {
  const auto* other = std::get_if<ConeShape>(&shape);
  return other && other->base == cone.base && other->axis == cone.axis && other->height == cone.height &&
         other->baseRadius == cone.baseRadius && other->slope == cone.slope;
}

bool isSame(const Shape& shape, const BoxShape& box) {
  const auto* other = std::get_if<BoxShape>(&shape);
  return other && other->min == box.min && other->max == box.max;
}

bool coincide(const Shape& a, const Shape& b) { return std::visit(Coincide{b}, a); }

}  // namespace candela::reference

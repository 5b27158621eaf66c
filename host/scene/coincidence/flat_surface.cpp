// Compares flat surfaces: by their planes, and by lines that separate them.
#include "host/scene/coincidence/flat_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/scene/coincidence/coincidence.h"

namespace candela::scene {
namespace {

using glm::dvec3;
using glm::vec3;

float largest(const vec3& v) { return std::max({v.x, v.y, v.z}); }

// Stores the flat parts of a shape, and counts those that have an area.
struct StoreFlatParts {
  std::uint32_t primitive;
  std::span<FlatSurface> parts;
  std::size_t& count;

  void operator()(const Triangle& t) const {
    const dvec3 normal = cross(dvec3(t.p[1]) - dvec3(t.p[0]), dvec3(t.p[2]) - dvec3(t.p[0]));
    storePolygon(t.p, normal);
  }
  void operator()(const Box& box) const {
    for (int axis = 0; axis < 3; ++axis) {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      for (const float at : {box.min[axis], box.max[axis]}) {
        std::array<vec3, 4> corners;
        for (std::size_t i = 0; i < 4; ++i) {
          corners[i][axis] = at;
          corners[i][u] = (i == 1 || i == 2 ? box.max : box.min)[u];
          corners[i][v] = (i >= 2 ? box.max : box.min)[v];
        }
        storePolygon(corners, cross(dvec3(corners[1] - corners[0]), dvec3(corners[3] - corners[0])));
      }
    }
  }
  void operator()(const Plane& plane) const {
    const dvec3 p(plane.p[0]);
    const dvec3 normal = normalize(cross(dvec3(plane.p[1]) - p, dvec3(plane.p[2]) - p));
    parts[count++] = {{plane.p[0]}, 0, primitive, largest(glm::abs(plane.p[0])), normal};
  }
  void operator()(const Sphere&) const {}
  void operator()(const Cone&) const {}

 private:
  void storePolygon(std::span<const vec3> corners, const dvec3& areaNormal) const {
    const double area = length(areaNormal);
    if (!(area > 0)) return;
    FlatSurface& part = parts[count++];
    std::ranges::copy(corners, part.corners.begin());
    part.cornerCount = static_cast<std::uint32_t>(corners.size());
    part.primitive = primitive;
    part.reach = reachOf(corners);
    part.normal = normalize(areaNormal);
  }
};

bool isWithin(const FlatSurface& flat, const FlatSurface& plane, double tolerance) {
  return std::ranges::all_of(flat.polygon(), [&](const vec3& corner) {
    return std::abs(dot(dvec3(corner) - dvec3(plane.corners[0]), plane.normal)) <= tolerance;
  });
}

// Returns whether a line along an edge of `a` separates two polygons, up to an overlap of this depth.
bool separates(const FlatSurface& a, const FlatSurface& b, int u, int v, double depth) {
  for (std::uint32_t i = 0; i < a.cornerCount; ++i) {
    const vec3& from = a.corners[i];
    const vec3& to = a.corners[(i + 1) % a.cornerCount];
    const glm::dvec2 across(double{from[v]} - to[v], double{to[u]} - from[u]);
    const auto height = [&](const vec3& p) {
      return across.x * (double{p[u]} - from[u]) + across.y * (double{p[v]} - from[v]);
    };
    double side = 0;  // of the third corner of `a`, all of which is on the same side
    for (const vec3& corner : a.polygon()) side = std::abs(height(corner)) > std::abs(side) ? height(corner) : side;
    double deepest = -std::numeric_limits<double>::infinity();
    for (const vec3& corner : b.polygon()) deepest = std::max(deepest, side > 0 ? height(corner) : -height(corner));
    if (deepest <= depth * length(across)) return true;
  }
  return false;
}

}  // namespace

float reachOf(std::span<const vec3> points) {
  float reach = 0;
  for (const vec3& point : points) reach = std::max(reach, largest(glm::abs(point)));
  return reach;
}

std::size_t flatPartCount(PrimitiveKind kind) {
  if (kind == PrimitiveKind::box) return 6;
  return kind == PrimitiveKind::triangle || kind == PrimitiveKind::plane ? 1 : 0;
}

std::size_t storeFlatParts(const Shape& shape, std::uint32_t primitive, std::span<FlatSurface> parts) {
  std::size_t count = 0;
  std::visit(StoreFlatParts{primitive, parts, count}, shape);
  return count;
}

ItemBox boxOf(const FlatSurface& surface, std::uint32_t index) {
  ItemBox box{surface.corners[0], surface.corners[0], index};
  for (const vec3& corner : surface.polygon()) {
    box.low = glm::min(box.low, corner), box.high = glm::max(box.high, corner);
  }
  const float pad = static_cast<float>(kCoplanarTolerance) * surface.reach;
  box.low -= pad;
  box.high += pad;
  return box;
}

bool mayLieIn(const FlatSurface& plane, const vec3& low, const vec3& high) {
  constexpr double kSlack = 1.001;  // covers the rounding of this function
  const dvec3 centre = 0.5 * (dvec3(low) + dvec3(high)), half = 0.5 * (dvec3(high) - dvec3(low));
  const double reach = std::max(plane.reach, std::max(largest(glm::abs(low)), largest(glm::abs(high))));
  const double distance = std::abs(dot(centre - dvec3(plane.corners[0]), plane.normal));
  return distance <= dot(half, glm::abs(plane.normal)) + kSlack * kCoplanarTolerance * reach;
}

bool overlapInPlane(const FlatSurface& a, const FlatSurface& b) {
  constexpr double kParallel = 0.9;  // rounding turns the normals of small triangles far from the origin
  if (std::abs(dot(a.normal, b.normal)) < kParallel) return false;
  const double tolerance = kCoplanarTolerance * double{std::max(a.reach, b.reach)};
  const bool aIsFinite = a.isFinite(), bIsFinite = b.isFinite();
  if (!aIsFinite && !bIsFinite) {
    const bool isParallel = length(cross(a.normal, b.normal)) <= kCoplanarTolerance;
    return isParallel && std::abs(dot(dvec3(a.corners[0]) - dvec3(b.corners[0]), b.normal)) <= tolerance;
  }
  const auto isCoplanar = [&] {
    return (aIsFinite && isWithin(a, b, tolerance)) || (bIsFinite && isWithin(b, a, tolerance));
  };
  if (!aIsFinite || !bIsFinite) return isCoplanar();
  const dvec3 size = glm::abs(a.normal);
  const int dropped = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const int u = (dropped + 1) % 3, v = (dropped + 2) % 3;
  return !separates(a, b, u, v, tolerance) && !separates(b, a, u, v, tolerance) && isCoplanar();
}

}  // namespace candela::scene

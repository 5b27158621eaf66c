// Splits a polygon, convex or concave, into triangles.
#include "host/formats/loading/triangulate.h"

#include <algorithm>
#include <cmath>

#include "host/formats/loading/ear_clipper.h"

namespace candela::scene {
namespace {

/// Returns Newell's sum: the normal, with twice the area as its length.
glm::dvec3 areaVector(std::span<const glm::vec3> polygon) {
  const glm::dvec3 origin = polygon[0];
  glm::dvec3 sum(0);
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    sum += glm::cross(glm::dvec3(polygon[i]) - origin, glm::dvec3(polygon[i + 1]) - origin);
  }
  return sum;
}

double largestDeviation(std::span<const glm::vec3> polygon, const glm::dvec3& normal) {
  const glm::dvec3 origin = polygon[0];
  double extent = 0;
  double deviation = 0;
  for (const glm::vec3& vertex : polygon) {
    const glm::dvec3 offset = glm::dvec3(vertex) - origin;
    extent = std::max(extent, glm::length(offset));
    deviation = std::max(deviation, std::abs(glm::dot(offset, normal)));
  }
  return extent > 0 ? deviation / extent : 0;
}

/// Drops the coordinate along which the projected polygon is largest, such that its winding becomes counter-clockwise.
std::vector<glm::dvec2> project(std::span<const glm::vec3> polygon, const glm::dvec3& normal) {
  int axis = 0;
  for (int i = 1; i < 3; ++i) {
    if (std::abs(normal[i]) > std::abs(normal[axis])) axis = i;
  }
  const bool front = normal[axis] > 0;
  const int x = (axis + (front ? 1 : 2)) % 3;
  const int y = (axis + (front ? 2 : 1)) % 3;
  std::vector<glm::dvec2> points;
  points.reserve(polygon.size());
  for (const glm::vec3& vertex : polygon) points.emplace_back(vertex[x], vertex[y]);
  return points;
}

bool crossProperly(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d) {
  const auto separate = [](double s, double t) { return (s > 0 && t < 0) || (s < 0 && t > 0); };
  return separate(orientation(a, b, c), orientation(a, b, d)) && separate(orientation(c, d, a), orientation(c, d, b));
}

bool crossesItself(const std::vector<glm::dvec2>& points) {
  // In larger polygons, only crossings that stop the clipping are detected.
  constexpr std::size_t kMaxCheckedVertices = 1024;
  const std::size_t count = points.size();
  if (count > kMaxCheckedVertices) return false;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 2; j < count; ++j) {
      if (crossProperly(points[i], points[(i + 1) % count], points[j], points[(j + 1) % count])) return true;
    }
  }
  return false;
}

Triangulation fan(std::size_t vertexCount) {
  Triangulation split;
  for (std::uint32_t i = 1; i + 1 < vertexCount; ++i) split.triangles.push_back({0, i, i + 1});
  return split;
}

/// Handles a polygon whose area vector is 0: it lies on a line, or its parts cancel each other.
Triangulation fanWithoutArea(std::span<const glm::vec3> polygon) {
  Triangulation split = fan(polygon.size());
  const auto isFlat = [&](const std::array<std::uint32_t, 3>& t) {
    const std::array<glm::vec3, 3> corners{polygon[t[0]], polygon[t[1]], polygon[t[2]]};
    return areaVector(corners) == glm::dvec3(0);
  };
  split.simple = std::ranges::all_of(split.triangles, isFlat);
  return split;
}

}  // namespace

Triangulation triangulate(std::span<const glm::vec3> polygon) {
  if (polygon.size() == 3) return fan(3);
  const glm::dvec3 area = areaVector(polygon);
  const double length = glm::length(area);
  if (!(length > 0)) return fanWithoutArea(polygon);

  const glm::dvec3 normal = area / length;
  const std::vector<glm::dvec2> points = project(polygon, normal);
  EarClipper clipper(points);
  Triangulation split;
  split.simple = clipper.clip() && !crossesItself(points);
  split.triangles = clipper.triangles();
  split.planeDeviation = largestDeviation(polygon, normal);
  return split;
}

}  // namespace candela::scene

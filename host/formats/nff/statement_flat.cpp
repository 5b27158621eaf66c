// `pl`, `npl` and `box`: infinite planes and axis-aligned boxes.
#include <cmath>

#include "host/formats/loading/scene_builder.h"
#include "host/formats/nff/parser.h"
#include "host/formats/nff/statements.h"

namespace candela::scene {
namespace {

constexpr double kMaxDistance = 1e38;  ///< maximum distance of a plane from the origin; leaves room for points around
                                       ///< the nearest point

/// Returns two vectors perpendicular to the unit vector n, with u x v = n (Duff et al., JCGT 2017). They are exact if n
/// is an axis.
void makeFrame(const glm::dvec3& n, glm::dvec3& u, glm::dvec3& v) {
  const double sign = std::copysign(1.0, n.z);
  const double a = -1 / (sign + n.z);
  const double b = n.x * n.y * a;
  u = {1 + sign * n.x * n.x * a, sign * b, -sign * n.x};
  v = {b, sign + n.y * n.y * a, -n.y};
}

}  // namespace

void parsePlane(Parser& parser) {
  Plane plane;
  for (glm::vec3& point : plane.p) point = parser.in.vector("a point of the plane");
  const glm::dvec3 origin = plane.p[0];
  const glm::dvec3 normal = glm::cross(glm::dvec3(plane.p[1]) - origin, glm::dvec3(plane.p[2]) - origin);
  if (normal == glm::dvec3(0)) StatementReader::fail(parser.keyword, "the plane's three points lie on a line");
  addPlane(parser.scene, plane, parser.currentMaterial());
}

// Reads the plane of all points with n . p + d = 0.
void parseHessianPlane(Parser& parser) {
  const Position position = parser.in.here();
  const glm::dvec3 normal = parser.in.vector("the normal");
  const double d = static_cast<double>(parser.in.number("the distance d of n . p + d = 0"));
  const double length = glm::length(normal);
  if (length == 0) StatementReader::fail(position, "the plane's normal has length 0");
  const glm::dvec3 n = normal / length;
  const glm::dvec3 origin = -d / length * n;
  if (!(glm::length(origin) < kMaxDistance))
    StatementReader::fail(position, "the plane is beyond the range of single precision");
  const double size = std::max(1.0, glm::length(origin));  // reduces the tilt of the plane by rounding
  glm::dvec3 u, v;
  makeFrame(n, u, v);
  const Plane plane{{glm::vec3(origin), glm::vec3(origin + size * u), glm::vec3(origin + size * v)}};
  addPlane(parser.scene, plane, parser.currentMaterial());
}

void parseBox(Parser& parser) {
  Box box;
  box.min = parser.in.vector("the minimum corner");
  box.max = parser.in.vector("the maximum corner");
  const Box sorted{glm::min(box.min, box.max), glm::max(box.min, box.max)};
  if (sorted.min != box.min)
    parser.log.warn("swapped box", parser.keyword, "the box's corners are swapped to min <= max");
  const std::uint32_t material = parser.currentMaterial();
  if (isEmissive(parser.scene.materials[material])) {
    addBoxAsTriangles(parser.scene, sorted, material);
  } else {
    addBox(parser.scene, sorted, material);
  }
}

}  // namespace candela::scene

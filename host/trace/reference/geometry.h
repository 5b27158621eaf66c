// Intersections of rays with spheres, triangles, boxes, cones and planes, and the normals there:
// docs/light-transport.md section 4. Distances are kNoHit if there is no hit, and above 0 otherwise. `startsHere` says
// that the primitive is the ray's origin primitive. A ray never hits a flat origin primitive.
#pragma once
#include <variant>

#include "host/scene/scene.h"
#include "host/trace/reference/ray.h"

namespace candela::reference {

using glm::dvec2;

/// Returns a distance that is a hit, or kNoHit.
inline double positiveOrNoHit(double t) { return t > 0 ? t : kNoHit; }

/// Radius < 0: the sphere is hit only from inside.
struct SphereShape {
  dvec3 centre;
  double radius;

  explicit SphereShape(const scene::Sphere& sphere);
  double distance(const Ray& ray, bool startsHere) const;
  /// Outward unit normal; towards the centre if the radius is negative.
  dvec3 normal(const dvec3& point) const;
};

struct TriangleShape {
  dvec3 corner;
  dvec3 corner1;
  dvec3 corner2;
  dvec3 edge1;  ///< from corner to corner1
  dvec3 edge2;  ///< from corner to corner2

  explicit TriangleShape(const scene::Triangle& triangle);
  /// Watertight: no ray passes between triangles that share an edge. Equal for equal triangles in any order of
  /// vertices.
  double distance(const Ray& ray) const;
  /// Returns the distance along the line of the ray, which may be negative; kNoHit if it misses the triangle.
  double lineDistance(const Ray& ray) const;
  /// Returns (b1, b2) of the point at which the ray intersects the triangle's plane.
  dvec2 barycentrics(const Ray& ray) const;
  /// Returns the normal, with twice the area as its length, on the side from which the corners are counter-clockwise.
  dvec3 areaNormal() const { return cross(edge1, edge2); }

 private:
  dvec3 sortedNormal_;  ///< parallel to areaNormal(), and equal for all orders of the vertices
};

struct BoxShape {
  dvec3 min;
  dvec3 max;

  explicit BoxShape(const scene::Box& box);
  double distance(const Ray& ray, bool startsHere) const;
  /// Outward unit normal of the face that the ray hits at `distance`.
  dvec3 normal(const Ray& ray, double distance, bool startsHere) const;

  /// The distances at which a line enters and exits the box (into > out: it misses), and the axes of the faces there.
  struct Crossings {
    double entry = -kNoHit;
    double exit = kNoHit;
    int entryAxis = 0;
    int exitAxis = 0;

    bool misses() const { return entry > exit; }
    dvec3 entryNormal(const Ray& ray) const;
    dvec3 exitNormal(const Ray& ray) const;
  };
  Crossings crossings(const Ray& ray) const;
};

struct ConeShape {
  dvec3 base;
  dvec3 axis;  ///< unit, from base to apex
  double height;
  double baseRadius;
  double slope;  ///< change of the radius per unit of height

  explicit ConeShape(const scene::Cone& cone);
  double distance(const Ray& ray, bool startsHere) const;
  /// Unit normal that points away from the axis.
  dvec3 normal(const dvec3& point) const;
};

struct PlaneShape {
  dvec3 point;
  dvec3 unitNormal;

  explicit PlaneShape(const scene::Plane& plane);
  double distance(const Ray& ray) const;
  /// Returns the distance along the line of the ray, which may be negative; kNoHit if it is parallel to the plane.
  double lineDistance(const Ray& ray) const;
};

using Shape = std::variant<SphereShape, TriangleShape, BoxShape, ConeShape, PlaneShape>;

/// Returns whether rays may hit a shape: whether it is not a triangle without area.
bool isEverHit(const Shape& shape);

/// Equal primitives have equal shapes; the ends of a cone may be exchanged.
Shape preparedShape(const scene::Scene& scene, const scene::Primitive& primitive);

}  // namespace candela::reference

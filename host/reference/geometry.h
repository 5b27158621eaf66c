// Where rays meet spheres, triangles, boxes, cones and planes, and the normals there: docs/light-transport.md
// section 4. Distances are kNoHit where there is no hit, and above 0 otherwise. `leaving` says that the ray starts on
// this very primitive, which flat ones never meet again.
#pragma once
#include "host/reference/ray.h"
#include "host/scene/scene.h"

namespace candela::reference {

using glm::dvec2;

/// Radius < 0: only the inside is there.
struct SphereShape {
  dvec3 centre;
  double radius;

  explicit SphereShape(const scene::Sphere& sphere);
  double distance(const Ray& ray, bool leaving) const;
  /// Outward; towards the centre if the radius is negative.
  dvec3 normal(const dvec3& point) const;
};

struct TriangleShape {
  dvec3 corner;
  dvec3 corner1;
  dvec3 corner2;
  dvec3 edge1;  ///< from corner to corner1
  dvec3 edge2;  ///< from corner to corner2

  explicit TriangleShape(const scene::Triangle& triangle);
  /// Watertight: rays do not pass between triangles that share an edge.
  double distance(const Ray& ray) const;
  /// (b1, b2) of the point where the ray meets the triangle's plane.
  dvec2 barycentrics(const Ray& ray) const;
  /// Twice the area long, to the side from which the corners run counter-clockwise.
  dvec3 areaNormal() const { return cross(edge1, edge2); }
};

struct BoxShape {
  dvec3 min;
  dvec3 max;

  explicit BoxShape(const scene::Box& box);
  double distance(const Ray& ray, bool leaving) const;
  /// Outward, of the face that `distance` found.
  dvec3 normal(const Ray& ray, bool leaving) const;

 private:
  /// Where a line crosses into and out of the box (into after out: it misses), and the axes of the faces there.
  struct Crossings {
    double entry = -kNoHit;
    double exit = kNoHit;
    int entryAxis = 0;
    int exitAxis = 0;
  };
  Crossings crossings(const Ray& ray) const;
};

struct ConeShape {
  dvec3 base;
  dvec3 axis;  ///< unit, from base to apex
  double height;
  double baseRadius;
  double slope;  ///< change of the radius per height

  explicit ConeShape(const scene::Cone& cone);
  double distance(const Ray& ray, bool leaving) const;
  /// Away from the axis.
  dvec3 normal(const dvec3& point) const;
};

struct PlaneShape {
  dvec3 point;
  dvec3 unitNormal;

  explicit PlaneShape(const scene::Plane& plane);
  double distance(const Ray& ray) const;
};

}  // namespace candela::reference

// Bounds what placements and their rounding do to the plane and the edges of a triangle.
//
// A vertex of an instance is A (x + h) + b for a vertex x of the mesh, where |h| is at most PlacedTolerance::vertex: an
// instance is an exact affine image of a mesh whose vertices are moved. Affine maps preserve planes, and the side of a
// line in a plane, so that all bounds can be stated in the space of the mesh.
#include "host/scene/coincidence/placed_surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/scene/coincidence/coincidence.h"
#include "host/scene/coincidence/flat_surface.h"

namespace candela::scene {
namespace {

using glm::dmat3;
using glm::dvec3;
using glm::vec3;

constexpr double kUnit = 0x1p-24;  // rounding of single precision, relative

constexpr double kMaxTurn = 0.25;  // tangent of the angle by which the tolerance turns the plane of a triangle

// Returns the largest factor by which a matrix stretches a vector: the root of the largest eigenvalue of M^T M, by the
// trigonometric solution for symmetric matrices.
double stretchOf(const dmat3& m) {
  const dmat3 squared = transpose(m) * m;
  const double mean = (squared[0][0] + squared[1][1] + squared[2][2]) / 3;
  const dmat3 rest = squared - dmat3(mean);
  const double spread = std::sqrt((dot(rest[0], rest[0]) + dot(rest[1], rest[1]) + dot(rest[2], rest[2])) / 6);
  if (!(spread > 0)) return std::sqrt(mean);
  const double half = std::clamp(determinant(rest / spread) / 2, -1.0, 1.0);
  return std::sqrt(mean + 2 * spread * std::cos(std::acos(half) / 3));
}

template <class Vector>
auto largestOf(const Vector& v) {
  return std::max({v.x, v.y, v.z});
}

// Compares two triangles in the plane of one of them, the owner.
class PlaneOf {
 public:
  // `stretch`: the reciprocal cosine of the angle between the plane's normal and the axis along which overlapInPlane()
  // projects both. Its tangent is smaller.
  PlaneOf(const MeshTriangle& owner, const MeshTriangle& other, const PlacedTolerance& tolerance, double stretch)
      : owner_(owner), other_(other), tolerance_(tolerance), stretch_(stretch) {
    const dvec3 at(owner.corners[0]);
    const dvec3 u = normalize(dvec3(owner.corners[1]) - at);
    const dvec3 v = cross(owner.normal, u);
    const auto inPlane = [&](const vec3& corner) {
      const dvec3 p = dvec3(corner) - at;
      return dvec3(dot(p, u), dot(p, v), dot(p, owner.normal));
    };
    for (std::size_t i = 0; i < 3; ++i) own_[i] = inPlane(owner.corners[i]), others_[i] = inPlane(other.corners[i]);
  }

  // Returns whether the corners of the other triangle may lie in the plane. A corner of the owner that moves by h moves
  // the plane at a point by h times the point's barycentric coordinate.
  bool mayHoldOther() const {
    constexpr double kSecondOrder = 1.6;  // the coordinates change, too, by less than 3 kMaxTurn / 4
    const double area = cross2(own_[1] - own_[0], own_[2] - own_[0]);
    return std::ranges::all_of(others_, [&](const dvec3& p) {
      const double above = std::abs(p.z);
      double leverage = 3 * tolerance_.condition * above / owner_.altitude;  // what is above is projected at an angle
      for (std::size_t i = 0; i < 3; ++i) {
        leverage += std::abs(cross2(own_[(i + 1) % 3] - own_[i], p - own_[i]) / area);
      }
      return above <= kSecondOrder * (tolerance_.plane + tolerance_.vertex * (1 + leverage));
    });
  }

  // Returns whether a line along an edge of either triangle separates both in every instance.
  bool isSeparated() const {
    return separates(owner_, own_, other_, others_) || separates(other_, others_, owner_, own_);
  }

 private:
  using Corners = std::array<dvec3, 3>;  // in the plane, and their heights above it

  static double cross2(const dvec3& a, const dvec3& b) { return a.x * b.y - a.y * b.x; }

  bool separates(const MeshTriangle& a, const Corners& ofA, const MeshTriangle& b, const Corners& ofB) const {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t next = (i + 1) % 3;
      const Line line(ofA[i], ofA[next]);
      const dvec3& third = ofA[(i + 2) % 3];
      const double side = line.distanceTo(third);
      if (std::abs(side) <= errorOf(line, third)) continue;
      bool isSeparate = true;
      for (std::size_t k = 0; k < 3 && isSeparate; ++k) {
        // Equal vertices of a mesh are equal in each instance.
        if (b.corners[k] == a.corners[i] || b.corners[k] == a.corners[next]) continue;
        const double depth = side > 0 ? line.distanceTo(ofB[k]) : -line.distanceTo(ofB[k]);
        isSeparate = depth <= -errorOf(line, ofB[k]) || isWithinTolerance(line, ofB[k], std::max(depth, 0.0));
      }
      if (isSeparate) return true;
    }
    return false;
  }

  // A line along an edge.
  struct Line {
    const dvec3& from;
    const dvec3 edge;
    const double length;

    Line(const dvec3& start, const dvec3& end)
        : from(start), edge(end - start), length(glm::length(glm::dvec2(edge))) {}

    double distanceTo(const dvec3& p) const { return cross2(edge, p - from) / length; }
    double along(const dvec3& p) const { return dot(glm::dvec2(edge), glm::dvec2(p - from)) / (length * length); }
    double above(const dvec3& p) const { return std::abs(p.z - from.z - along(p) * edge.z); }
  };

  // Returns the maximum error of the distance of a point from a line: by vertices that move, and by the angle at which
  // what is above or below the line is projected.
  double errorOf(const Line& line, const dvec3& p) const {
    const dvec3 offset = p - line.from;
    const double moved = stretch_ * tolerance_.vertex;
    const double turned = (2 * moved * (glm::length(glm::dvec2(offset)) + line.length) + 4 * moved * moved) /
                          line.length;
    return turned + stretch_ * tolerance_.condition * line.above(p);
  }

  // Returns whether a point that is beyond a line by this depth is beyond it by at most e in every instance. This is so
  // for the corners of neighbours in a flat mesh which are on a common line.
  bool isWithinTolerance(const Line& line, const dvec3& p, double depth) const {
    const double along = line.along(p);
    const double moved = tolerance_.maxMoved * (1 + std::abs(along) + std::abs(1 - along));
    return tolerance_.condition * (depth + stretch_ * line.above(p)) <= (1 - moved) * tolerance_.minPlane;
  }

  const MeshTriangle& owner_;
  const MeshTriangle& other_;
  const PlacedTolerance& tolerance_;
  double stretch_;
  Corners own_, others_;
};

}  // namespace

void PlacedTolerance::include(const PlacedTolerance& other) {
  plane = std::max(plane, other.plane);
  vertex = std::max(vertex, other.vertex);
  condition = std::max(condition, other.condition);
  minPlane = std::min(minPlane, other.minPlane);
  maxMoved = std::max(maxMoved, other.maxMoved);
}

PlacedTolerance toleranceOf(const Placement& placement, const vec3& low, const vec3& high) {
  const dmat3 linear = linearPartOf(placement);
  const dvec3 products = magnitudesOf(linear) * glm::max(glm::abs(dvec3(low)), glm::abs(dvec3(high)));
  vec3 placedLow = low, placedHigh = high;
  BoxPlacement{placement}(placedLow, placedHigh);
  const double reach = double{reachOf(std::array{placedLow, placedHigh})};
  const double minReach = std::max({0.0f, largestOf(placedLow), largestOf(-placedHigh)});
  // Each product is rounded, and so are three sums, of which the last one has the largest coordinate.
  const double moved = std::numbers::sqrt3 * kUnit * (3 * largestOf(products) + reach);
  const double inverse = stretchOf(glm::inverse(linear));
  return {kCoplanarTolerance * reach * inverse, moved * inverse, stretchOf(linear) * inverse,
          kCoplanarTolerance * minReach * inverse, moved / (kCoplanarTolerance * minReach)};
}

BoxPlacement::BoxPlacement(const Placement& placement)
    : linear_(linearPartOf(placement)), magnitudes_(magnitudesOf(linear_)), translation_(translationOf(placement)) {}

void BoxPlacement::operator()(vec3& low, vec3& high) const {
  constexpr double kPad = 0x1p-20;  // kCoplanarTolerance, and as much for rounding
  const dvec3 centre = 0.5 * (dvec3(low) + dvec3(high)), half = 0.5 * (dvec3(high) - dvec3(low));
  const dvec3 placed = linear_ * centre + translation_;
  const dvec3 reach = magnitudes_ * half;
  const dvec3 pad(kPad * largestOf(magnitudes_ * glm::abs(centre) + reach + glm::abs(translation_)));
  low = vec3(placed - reach - pad);
  high = vec3(placed + reach + pad);
}

std::optional<MeshTriangle> meshTriangleOf(const Triangle& triangle) {
  const auto& [a, b, c] = triangle.p;
  if (a == b || b == c || c == a) return std::nullopt;
  const dvec3 ab = dvec3(b) - dvec3(a), ac = dvec3(c) - dvec3(a), bc = dvec3(c) - dvec3(b);
  const dvec3 normal = cross(ab, ac);
  const double area = length(normal);
  return MeshTriangle{{a, b, c}, normal / area, area / std::max({length(ab), length(ac), length(bc)})};
}

bool mayCoincide(const MeshTriangle& a, const MeshTriangle& b, const PlacedTolerance& tolerance) {
  const double turn = 2 * (tolerance.plane + 2 * tolerance.vertex) / std::min(a.altitude, b.altitude);
  if (!(turn < kMaxTurn)) return true;
  // The angle between a normal and the nearest axis is at most acos(1 / sqrt(3)), and both planes may be turned.
  const double cosine = ((1 - turn * turn) * std::sqrt(1 / 3.0) - 2 * turn * std::sqrt(2 / 3.0)) / (1 + turn * turn);
  const auto isApart = [&](const MeshTriangle& owner, const MeshTriangle& other) {
    const PlaneOf plane(owner, other, tolerance, 1 / cosine);
    return !plane.mayHoldOther() || plane.isSeparated();
  };
  return !isApart(a, b) || !isApart(b, a);
}

}  // namespace candela::scene

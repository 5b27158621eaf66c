// Cells of half vectors, which follow the shape of a rough surface's highlight: equal steps of log(1 + tan^2 /
// alpha^2).
#pragma once
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>
#include <vector>

#include "tests/proof/hemisphere.h"

namespace candela::proof {

/// Quadrature over the directions that half vectors reflect into the hemisphere, and the cells of sampled directions.
class SlopeGrid {
 public:
  using Point = HemisphereGrid::Point;

  SlopeGrid(int rows, int columns, const glm::dvec3& wo, double alpha)
      : wo_(wo), alpha_(alpha), scale_(std::log1p(std::pow(kSteepest / alpha, 2))) {
    // HemisphereGrid has the nodes of the unit square as heights and turns.
    const HemisphereGrid nodes(rows, columns);
    for (const Point& node : nodes.points()) addPoint(node);
  }

  const std::vector<Point>& points() const { return points_; }

  /// Cells outside the unit square hold what is steeper.
  glm::dvec2 placeOf(const glm::dvec3& wi) const {
    const glm::dvec3 h = normalize(wo_ + wi);
    const double t = (h.x * h.x + h.y * h.y) / (h.z * h.z) / (alpha_ * alpha_);
    return {std::log1p(t) / scale_, turns(h.x, h.y)};
  }

 private:
  static constexpr double kSteepest = 30;  // tangent

  void addPoint(const Point& node) {
    const double t = std::expm1(node.place.x * scale_);
    const double cosH = 1 / std::sqrt(1 + alpha_ * alpha_ * t);
    const glm::dvec3 h = directionAt(cosH, node.place.y);
    const glm::dvec3 wi = 2 * dot(wo_, h) * h - wo_;
    if (dot(wo_, h) <= 0 || wi.z <= 0) return;
    const double ofHalf = std::pow(cosH, 3) / 2 * alpha_ * alpha_ * (1 + t) * scale_ * node.solidAngle;
    points_.push_back({wi, node.place, 4 * dot(wo_, h) * ofHalf});
  }

  glm::dvec3 wo_;
  double alpha_;
  double scale_;
  std::vector<Point> points_;
};

}  // namespace candela::proof

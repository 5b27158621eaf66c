// Cells of half vectors, which follow the shape of a rough surface's highlight: equal steps of log(1 + tan^2 /
// alpha^2), with alpha along x and along y.
#pragma once
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>
#include <vector>

#include "tests/proof/hemisphere.h"

namespace candela::proof {

/// Where microfacets send light: they reflect it, they transmit it as a thin wall, or they refract it.
enum class Passage { reflected, thin, refracted };

/// Quadrature over the directions to which half vectors send light, and the cells of sampled directions.
class SlopeGrid {
 public:
  using Point = HemisphereGrid::Point;

  /// `eta`, not used except for refraction, is the index beyond the surface divided by that on the side of wo.
  SlopeGrid(int rows, int columns, const glm::dvec3& wo, const glm::dvec2& alpha, Passage passage, double eta)
      : wo_(wo),
        alpha_(alpha),
        passage_(passage),
        eta_(eta),
        scale_(std::log1p(std::pow(kSteepest / std::min(alpha.x, alpha.y), 2))) {
    const HemisphereGrid nodes(rows, columns);  // its places are the nodes of the unit square
    for (const Point& node : nodes.points()) addPoint(node);
  }

  const std::vector<Point>& points() const { return points_; }

  /// Cells outside the unit square hold what is steeper.
  glm::dvec2 placeOf(const glm::dvec3& wi) const {
    const glm::dvec3 h = halfVector(wi);
    const glm::dvec2 slope = glm::dvec2(h) / h.z / alpha_;
    return {std::log1p(dot(slope, slope)) / scale_, turns(slope.x, slope.y)};
  }

 private:
  static constexpr double kSteepest = 30;  // tangent

  glm::dvec3 halfVector(const glm::dvec3& wi) const {
    if (passage_ == Passage::reflected) return normalize(wo_ + wi);
    if (passage_ == Passage::thin) return normalize(wo_ + glm::dvec3(wi.x, wi.y, -wi.z));
    const glm::dvec3 h = normalize(wo_ + eta_ * wi);
    return h.z < 0 ? -h : h;
  }

  void addPoint(const Point& node) {
    const double t = std::expm1(node.place.x * scale_);
    const double azimuth = 2 * std::numbers::pi * node.place.y;
    const glm::dvec2 slope = std::sqrt(t) * alpha_ * glm::dvec2(std::cos(azimuth), std::sin(azimuth));
    const glm::dvec3 h = normalize(glm::dvec3(slope, 1));
    const double ofHalf = std::pow(h.z, 3) / 2 * alpha_.x * alpha_.y * (1 + t) * scale_ * node.solidAngle;
    if (dot(wo_, h) <= 0) return;
    if (passage_ == Passage::refracted)
      addRefracted(h, node.place, ofHalf);
    else
      addReflected(h, node.place, ofHalf);
  }

  void addReflected(const glm::dvec3& h, const glm::dvec2& place, double ofHalf) {
    glm::dvec3 wi = 2 * dot(wo_, h) * h - wo_;
    if (wi.z <= 0) return;
    if (passage_ == Passage::thin) wi.z = -wi.z;
    points_.push_back({wi, place, 4 * dot(wo_, h) * ofHalf});
  }

  void addRefracted(const glm::dvec3& h, const glm::dvec2& place, double ofHalf) {
    const glm::dvec3 wi = glm::refract(-wo_, h, 1 / eta_);
    if (wi == glm::dvec3(0) || wi.z >= 0) return;
    const double cosI = dot(wi, h), sum = dot(wo_, h) + eta_ * cosI;
    points_.push_back({wi, place, ofHalf * sum * sum / (eta_ * eta_ * -cosI)});
  }

  glm::dvec3 wo_;
  glm::dvec2 alpha_;
  Passage passage_;
  double eta_;
  double scale_;
  std::vector<Point> points_;
};

}  // namespace candela::proof

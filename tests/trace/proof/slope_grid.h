// Cells of half vectors, which follow the shape of a rough surface's highlight: equal steps of log(1 + tan^2 /
// alpha^2), with alpha along x and along y.
#pragma once
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

#include "tests/trace/proof/hemisphere.h"

namespace candela::proof {

/// The ways in which microfacets scatter light: they reflect it, transmit it as a thin wall, or refract it.
enum class Passage { reflected, thin, refracted };

/// Quadrature over the directions to which half vectors send light, and the cells of sampled directions.
class SlopeGrid {
 public:
  using Point = QuadraturePoint;

  /// Nodes are those of a hemisphere, whose coordinates are used. `eta`, not used except for refraction, is the index
  /// beyond the surface divided by that on the side of wo.
  SlopeGrid(std::span<const Point> nodes, const glm::dvec3& wo, const glm::dvec2& alpha, Passage passage, double eta)
      : wo_(wo),
        alpha_(alpha),
        passage_(passage),
        eta_(eta),
        scale_(std::log1p(std::pow(kSteepest / std::min(alpha.x, alpha.y), 2))) {
    for (const Point& node : nodes) addPoint(node);
  }

  const std::vector<Point>& points() const { return points_; }

  /// Cells outside the unit square contain steeper half vectors.
  glm::dvec2 placeOf(const glm::dvec3& wi) const {
    const glm::dvec2 slope = slopeOf(halfVector(wi));
    return {std::log1p(dot(slope, slope)) / scale_, turns(slope.x, slope.y)};
  }

  /// Returns the solid angle for each unit of the square's area around a direction. It is infinite where the quadrature
  /// has no points.
  double spreadAt(const glm::dvec3& wi) const {
    const glm::dvec3 h = halfVector(wi);
    const glm::dvec2 slope = slopeOf(h);
    const double t = dot(slope, slope), factor = solidAngleFactor(wi, h);
    if (factor <= 0 || std::log1p(t) > scale_) return std::numeric_limits<double>::infinity();
    return 2 * std::numbers::pi * factor * spreadOfHalf(h, t);
  }

 private:
  static constexpr double kSteepest = 30;  // tangent

  glm::dvec3 halfVector(const glm::dvec3& wi) const {
    if (passage_ == Passage::reflected) return normalize(wo_ + wi);
    if (passage_ == Passage::thin) return normalize(wo_ + glm::dvec3(wi.x, wi.y, -wi.z));
    const glm::dvec3 h = normalize(wo_ + eta_ * wi);
    return h.z < 0 ? -h : h;
  }

  glm::dvec2 slopeOf(const glm::dvec3& h) const { return glm::dvec2(h) / h.z / alpha_; }

  // Returns the solid angle of half vectors for that of the unit hemisphere's nodes.
  double spreadOfHalf(const glm::dvec3& h, double t) const {
    return h.z * h.z * h.z / 2 * alpha_.x * alpha_.y * (1 + t) * scale_;
  }

  // Returns the solid angle of directions for that of half vectors; 0 for a half vector that does not send light to wi.
  double solidAngleFactor(const glm::dvec3& wi, const glm::dvec3& h) const {
    const double cosO = dot(wo_, h), cosI = dot(wi, h);
    if (cosO <= 0) return 0;
    if (passage_ != Passage::refracted) return 4 * cosO;
    const double sum = cosO + eta_ * cosI;
    return cosI < 0 ? sum * sum / (eta_ * eta_ * -cosI) : 0;
  }

  void addPoint(const Point& node) {
    const double t = std::expm1(node.place.x * scale_);
    const double azimuth = 2 * std::numbers::pi * node.place.y;
    const glm::dvec2 slope = std::sqrt(t) * alpha_ * glm::dvec2(std::cos(azimuth), std::sin(azimuth));
    const glm::dvec3 h = normalize(glm::dvec3(slope, 1));
    if (dot(wo_, h) <= 0) return;
    const glm::dvec3 wi = passage_ == Passage::refracted ? glm::refract(-wo_, h, 1 / eta_) : 2 * dot(wo_, h) * h - wo_;
    const bool reflects = passage_ != Passage::refracted;
    if (reflects ? wi.z <= 0 : wi.z >= 0) return;
    const glm::dvec3 sent = passage_ == Passage::thin ? glm::dvec3(wi.x, wi.y, -wi.z) : wi;
    points_.push_back({sent, node.place, solidAngleFactor(wi, h) * spreadOfHalf(h, t) * node.solidAngle});
  }

  glm::dvec3 wo_;
  glm::dvec2 alpha_;
  Passage passage_;
  double eta_;
  double scale_;
  std::vector<Point> points_;
};

}  // namespace candela::proof

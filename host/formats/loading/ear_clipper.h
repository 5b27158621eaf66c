// Ear clipping of one polygon in the plane.
#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace candela::scene {

/// Returns twice the signed area of the triangle a b c, positive if it is counter-clockwise.
inline double orientation(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

class EarClipper {
 public:
  using Triangles = std::vector<std::array<std::uint32_t, 3>>;

  /// The winding of `points` is counter-clockwise: their signed area is positive.
  explicit EarClipper(std::vector<glm::dvec2> points);
  /// Clips all ears. Returns false if there was no ear at some time, because the polygon crosses itself; where this
  /// happens often, the rest is cut without regard to ears, so that the time stays quadratic.
  bool clip();
  const Triangles& triangles() const { return triangles_; }

 private:
  bool isReflex(std::uint32_t i) const;
  bool isEar(std::uint32_t i) const;
  bool blocks(std::uint32_t vertex, std::uint32_t ear) const;
  void unlink(std::uint32_t i);
  void cut(std::uint32_t i);
  void revisit(std::uint32_t vertex);
  void revisitAll();
  void cutAnyway();
  void cutRest();

  std::vector<glm::dvec2> points_;
  std::vector<std::uint32_t> previous_, next_;
  std::vector<bool> linked_;
  /// Reflex vertices at the last full search. Clipping ears makes no new ones, and only they block ears.
  std::vector<std::uint32_t> reflex_;
  std::vector<std::uint32_t> queue_;  ///< vertices that may be ears; read from the front
  std::size_t queueFront_ = 0;
  std::size_t remaining_ = 0;
  std::uint32_t someVertex_ = 0;  ///< a vertex that is still linked
  Triangles triangles_;
};

}  // namespace candela::scene

// A valley with a lake between hills: the ground on which the forest stands.
#pragma once
#include <vector>

#include "host/scene/generate/gltf_document.h"

namespace candela::generate {

/// Positions on the map are (x, z), in metres; the water is at height 0. The view is from the origin to -z.
class LakeValley {
 public:
  LakeValley();

  /// Returns the approximate distance from the shore in metres, negative on the lake.
  static double shoreDistance(const glm::dvec2& place);
  /// Returns the height of the mesh of the ground.
  double heightAt(const glm::dvec2& place) const;
  /// Returns the slope of the ground: 0 where it is level, 1 at 45 degrees.
  double slopeAt(const glm::dvec2& place) const;

  /// Returns whether the mesh of the ground reaches this far.
  bool contains(const glm::dvec2& place) const;

  /// Returns the ground, with colours.
  TriangleMesh groundMesh() const;
  /// Returns the surface of the lake, with the normals of small waves.
  static TriangleMesh waterMesh();

 private:
  double heightOf(std::size_t column, std::size_t row) const { return heights_[row * columns_.size() + column]; }

  std::vector<double> columns_;  // x of the grid's lines
  std::vector<double> rows_;     // z
  std::vector<double> heights_;
};

}  // namespace candela::generate

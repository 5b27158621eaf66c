// Plants that are grown from tables of numbers: branches as tubes, and leaves as folded quads.
#pragma once
#include <cstdint>
#include <span>

#include "host/scene/generate/gltf_document.h"

namespace candela::generate {

/// The branches of one generation. The first generation is the trunk. Angles are in degrees.
struct BranchLevel {
  int count;          ///< on each branch of the generation before
  double from;        ///< fraction of that branch at which they begin
  double lowAngle;    ///< from its direction, at `from`
  double highAngle;   ///< at its tip
  double length;      ///< in metres
  double radius;      ///< relative to that of the branch that bears them, where they begin; of a trunk in metres
  double taper;       ///< fraction of the radius that is left at the tip
  double lift;        ///< by how much branches turn to the sky along their length; negative: to the ground
  double wander;      ///< by how much they bend at random
  int segments;       ///< along a branch
  int sides;          ///< around a branch
  double tipLength;   ///< length of those at the tip, relative to those at `from`
  double middle = 0;  ///< by how much those in the middle are longer than linear interpolation says
};

/// The leaves of a branch of the last generation.
struct LeafStyle {
  int count;
  double from;     ///< fraction of the branch at which they begin
  double length;   ///< in metres
  double width;    ///< in metres
  double spread;   ///< distance from the branch, in metres
  double scatter;  ///< 0: leaves point along and to the sides of the branch; 1: anywhere
  double droop;    ///< by how much leaves hang
  double fold;     ///< height of their sides above the midrib, relative to the width
};

struct PlantStyle {
  std::span<const BranchLevel> levels;
  LeafStyle leaves;
  double crownCentre;  ///< height of the point from which the normals of leaves point away, in metres
};

struct Plant {
  TriangleMesh bark;
  TriangleMesh leaves;
};

/// Grows a plant at the origin. The trunk begins 0.6 m below it.
Plant growPlant(const PlantStyle& style, std::uint32_t seed);

/// Returns a tuft of blades of grass, about 0.5 m high.
TriangleMesh grassTuft(std::uint32_t blades, std::uint32_t seed);

}  // namespace candela::generate

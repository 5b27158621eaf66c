// A sphere as one closed mesh, made from the grids on the faces of a cube.
#pragma once
#include <cstdint>
#include <functional>

#include "host/scene/generate/nff_writer.h"

namespace candela::generate {

/// A face of the cube: the axis of its normal, its side, and the axes of its grid. The three axes are right-handed on
/// the positive side.
struct CubeFace {
  int normal;
  double side;  ///< 1 or -1
  int u() const { return (normal + 1) % 3; }
  int v() const { return (normal + 2) % 3; }
};

/// Writes 12 size^2 triangles that face outwards. `place` maps the unit vector of each vertex to its position. Adjacent
/// faces give bit-identical vertices at their common edges.
void writeCubeSphere(NffWriter& out, std::uint32_t size,
                     const std::function<glm::dvec3(const glm::dvec3& direction)>& place);

}  // namespace candela::generate

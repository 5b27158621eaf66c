// A cube's grid blown up to a sphere, as one closed mesh.
#pragma once
#include <cstdint>
#include <functional>

#include "host/generate/nff_writer.h"

namespace candela::generate {

/// Of a cube's face: the axis that it is normal to, on which side, and the axes of its grid, such that the three are
/// right-handed on the positive side.
struct CubeFace {
  int normal;
  double side;  ///< 1 or -1
  int u() const { return (normal + 1) % 3; }
  int v() const { return (normal + 2) % 3; }
};

/// 12 size^2 triangles that face outwards. `place` moves the unit vector to each vertex to where the vertex lies; faces
/// that meet give it the same bits at their common edges.
void writeCubeSphere(NffWriter& out, std::uint32_t size,
                     const std::function<glm::dvec3(const glm::dvec3& direction)>& place);

}  // namespace candela::generate

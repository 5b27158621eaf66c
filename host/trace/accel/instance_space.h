// The space of an instance's mesh, in which rays traverse the BVH of the mesh, and the padding that keeps them from
// losing a hit.
//
// An instance places the vertices p of a mesh by an affine map A p + b with the entries of scene::Placement. The device
// transforms a ray o + t d by an approximation W o + w, W d of the inverse map, and tests the boxes of the mesh with
// it. Primitives are tested with their vertices in the scene. With u = 2^-24, |.| for the largest coordinate and, of a
// matrix, the largest sum of the magnitudes of a row; P_j the largest magnitude of coordinate j in the mesh; and R the
// largest of sum_j |A_ij| P_j + |b_i|, let a primitive be hit at X = o + t d:
//
// - X is at most 20 u (R + |o|) from a point of the triangle whose vertices are rounded (primitive_bounds.h), and that
//   is at most 4 u R (to first order in u) from the exact image of a point y of the mesh's triangle.
// - Hence the exact inverse image of X is at most |A^-1| (24 u R + 20 u |o|) from y.
// - W and w are rounded from double precision, and their application has three products and three sums: the origin in
// the
//   mesh has an error of at most 5 u (|A^-1| |o| + |w|), and t W d of at most 4 u |A^-1| |t d|, where |t d| <= |X| +
//   |o|
//   <= R + 2 |o| to first order.
//
// The point at t of the ray in the mesh is thus at most |A^-1| (28 u R + 33 u |o|) + 5 u |w| from y. The rounding of
// the test of the box itself, in the mesh's coordinates, is what the paddings of primitive_bounds.h and
// quantised_boxes.h are for; these are added to the padding here. It is
//
//   40 u (|A^-1| R + |w|) + 40 u |A^-1| |o|,
//
// with room for terms of higher order and for the rounding of the padding itself. Distances t are those of the scene,
// so that nodes are pruned by them without any further slack.
//
// Surfaces that coincide with the ray's origin primitive are hit although rounding puts them before the ray's origin:
// |A^-1| 32 u C is added, where C is the largest coordinate of such surfaces.
#pragma once
#include <array>
#include <glm/glm.hpp>

#include "host/scene/placement.h"
#include "host/trace/accel/bounds.h"

namespace candela::accel {

struct InstanceSpace {
  std::array<glm::vec3, 4> columns;  ///< of W, and w
  float padding;                     ///< of rays, besides that of primitive_bounds.h
  float paddingPerOrigin;            ///< times the largest coordinate of a ray's origin in the scene
};

/// `meshBounds` contains the vertices of the mesh. `coincidentReach`: C, or 0 if no triangle of the instance coincides
/// with another surface.
InstanceSpace instanceSpace(const scene::Placement& placement, const Aabb& meshBounds, float coincidentReach);

/// Returns a box that contains the vertices of an instance that are in `box` in the mesh, with the padding of
/// primitiveBounds().
Aabb placedBounds(const scene::Placement& placement, const Aabb& box);

}  // namespace candela::accel

// Bounding boxes of a scene's primitives, wide enough that a box test in single precision never loses a hit.
//
// A tracer in single precision accepts rays that pass a primitive by a little, and its box test errs by a little too. A
// hit would be lost, and the image would depend on the structure, if the second error went against the first. Both are
// rounding errors of differences between the primitive's coordinates p and the ray's origin o, so that both move a
// surface by a multiple of u |p - o|, where u = 2^-24 and |p - o| <= |p| + |o|:
//
// - the box test (box - o) * (1 / d) by at most 8 u |p - o|, a division of 2.5 ulp (all that Vulkan asks for) included;
// - a primitive test without cancellation (see below) by less than 20 u |p - o|.
//
// Hence two pads of 2^-19 = 32 u, one for each term of |p| + |o|:
//
// - of the box: 2^-19 times its largest coordinate in magnitude. The boxes given here have it.
// - of the ray, which alone knows its origin; at the nodes it costs nothing. With e = 2^-19 max(|o.x|, |o.y|, |o.z|)
//   faces are tested as   t0 = (box.min - (o + e)) * inverse,   t1 = (box.max - (o - e)) * inverse.
//
// Components of a direction below 2^-100 in magnitude are set to +-2^-100 first, so that 0 * infinity cannot come up.
// The factor 1 + 2 gamma(3) on the far distance (Ize, JCGT 2013) is part of these 8 u: harmless, and not needed.
//
// Rounding is monotonic, so a box accepted in this way has accepted ancestors, and no greater distance is found there:
// nodes need no pad of their own. For the same reason a primitive test that also meets its own padded box, and takes no
// distance smaller than where it enters it, is independent of the structure by construction, whatever its errors.
//
// Free of cancellation are: the sphere by the distance of its centre to the ray's closest point (Haines et al., Ray
// Tracing Gems, ch. 7; b*b - c errs by u |p - o|^2 / radius instead, which is unbounded for small, far spheres); the
// cone after the origin was moved to the ray's closest point to the axis (to one point of the axis is not enough: long
// thin cones then lose hits); a box by slabs; the triangle sheared to the ray (Woop et al., JCGT 2013). Signed volumes
// of the ray with a triangle's edges are not quite. In both triangle tests a needle's distance errs by u length^2 /
// width and more: of the hits on needles about one in a million falls outside the box and depends on the structure.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "host/accel/bounds.h"
#include "host/scene/scene.h"

namespace candela::accel {

/// Share of the largest coordinate, of box or ray origin, by which boxes are widened.
inline constexpr float kBoundsPad = 0x1p-19f;
/// Largest coordinate of a box in magnitude, about 1.1e12: products of three distances stay finite in single precision.
inline constexpr float kMaxCoordinate = 0x1p40f;

/// The padded box of one primitive, computed in double and rounded outward; none for a plane, which has no end.
/// Throws FileError if it reaches beyond kMaxCoordinate.
std::optional<Aabb> primitiveBounds(const scene::Scene& scene, const scene::Primitive& primitive);

/// All primitives of a scene: `finite` and `infinite` hold primitive indices in ascending order, bounds[i] is the box
/// of finite[i]. Infinite primitives are tested by every ray.
struct SceneBounds {
  std::vector<Aabb> bounds;
  std::vector<std::uint32_t> finite;
  std::vector<std::uint32_t> infinite;
};
/// Throws FileError as primitiveBounds does.
SceneBounds boundPrimitives(const scene::Scene& scene);

}  // namespace candela::accel

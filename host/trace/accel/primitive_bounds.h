// Bounding boxes of a scene's primitives, padded such that a box test in single precision never loses a hit.
//
// A tracer in single precision accepts rays that miss a primitive by a small distance, and its box test has a small
// error as well. If the second error acted against the first, a hit would be lost, and the image would depend on the
// acceleration structure. Both are rounding errors of differences between the coordinates p of the primitive and the
// origin o of the ray, so that both move a surface by a multiple of u |p - o|, where u = 2^-24 and |p - o| <= |p| +
// |o|:
//
// - the box test (box - o) * (1 / d) by at most 8 u |p - o|, including a division of 2.5 ulp, the precision that Vulkan
//   requires;
// - a primitive test without cancellation (see below) by less than 20 u |p - o|, or towards greater distances.
//
// Hence there are two pads of 2^-19 = 32 u, one for each term of |p| + |o|:
//
// - the pad of the box: 2^-19 times its largest coordinate in magnitude. The boxes returned here include it.
// - the pad of the ray, which depends on its origin and costs nothing at the nodes. With e = 2^-19 max(|o.x|, |o.y|,
//   |o.z|), faces are tested as   t0 = (box.min - (o + e)) * inverse,   t1 = (box.max - (o - e)) * inverse.
//
// Components of a direction below 2^-100 in magnitude are first set to +-2^-100, so that 0 * infinity does not occur.
// The factor 1 + 2 gamma(3) on the far distance (Ize, JCGT 2013) is part of these 8 u: it is harmless, but not needed.
//
// Rounding is monotonic, so the ancestors of an accepted box are accepted too, at a distance that is not greater: nodes
// need no separate padding. For the same reason, a primitive test that also intersects its own padded box, and accepts
// no distance smaller than the entry into it, is independent of the structure by construction, whatever its errors.
//
// These tests are free of cancellation: the sphere by the distance of its centre from the closest point of the ray
// (Haines et al., Ray Tracing Gems, ch. 7; b*b - c has an error of u |p - o|^2 / radius instead, which is unbounded for
// small, distant spheres); the cone after the origin is moved to the point of the ray that is closest to the axis (the
// point closest to one point of the axis is not sufficient: long thin cones then lose hits); the box by slabs; the
// triangle sheared to the ray (Woop et al., JCGT 2013). The weights of a triangle's vertices are not free of it: the
// distance has an error of u length^2 / width and more. Since a distance is rounded up by a bound of this error, it is
// not smaller than that of a triangle whose vertices are at most 20 u |p - o| away, as above. A distance that is too
// large does no harm: the node of a triangle is entered before it, and no node is skipped that is entered earlier. (The
// distance of a triangle that coincides with another surface is not rounded up, so that hits on a needle in the plane
// of another surface may depend on the structure.)
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "host/scene/scene.h"
#include "host/trace/accel/bounds.h"

namespace candela::accel {

/// Padding of boxes and of rays, as a fraction of the largest coordinate of the box or the ray origin.
inline constexpr float kBoundsPad = 0x1p-19f;
/// Maximum coordinate of a box in magnitude, about 1.1e12: products of three distances stay finite in single precision.
inline constexpr float kMaxCoordinate = 0x1p40f;

/// Returns the box from min to max with its padding, rounded outward.
Aabb paddedBounds(const glm::dvec3& min, const glm::dvec3& max);

/// Returns the largest magnitude of a box's coordinates.
float largestCoordinate(const Aabb& box);

/// Returns the padded box of one primitive, computed in double precision and rounded outward, or nothing for an
/// infinite plane. Throws FileError if it exceeds kMaxCoordinate.
std::optional<Aabb> primitiveBounds(const scene::Scene& scene, const scene::Primitive& primitive);

/// Primitives of a scene: `finite` and `infinite` contain primitive indices in ascending order, and bounds[i] is
/// the box of finite[i]. Every ray tests the infinite primitives.
struct SceneBounds {
  std::vector<Aabb> bounds;
  std::vector<std::uint32_t> finite;
  std::vector<std::uint32_t> infinite;
  float coincidentReach = 0;  ///< largest coordinate of coincident primitives, by which their boxes are padded
};
/// Throws FileError like primitiveBounds. `coincident`: surfaces that rays hit although rounding puts them before the
/// ray's origin, because they coincide with the surface on which the ray starts (scene::Coincidences::coincident).
/// Their boxes are padded further, by the pad of the largest of them and of a coordinate `coincidentReach`. Empty:
/// there are none. `leavesOut`: runs whose primitives are left out; empty: none.
SceneBounds boundPrimitives(const scene::Scene& scene, const std::vector<bool>& coincident = {},
                            const std::vector<bool>& leavesOut = {}, float coincidentReach = 0);

}  // namespace candela::accel

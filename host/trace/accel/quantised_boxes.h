// Eight boxes on a grid of 256 planes per axis, and a proof that no hit is lost by their rounding.
//
// host/trace/accel/primitive_bounds.h pads the box of a primitive with coordinates p by 32 u |p|, and the ray by 32 u
// |o|, with u = 2^-24. A primitive test may use 20 u (|p| + |o|) of this padding, and the test of the box 8 u (|p| +
// |o|). Kernels test planes of the grid instead:
//
//   t = q * (step * inverse) + (origin - (o +- pad)) * inverse,   plane = origin + q * step,   step a power of two.
//
// Products with the step are exact. On each axis, t therefore has at most these errors, in units of length:
//   u q step                      of the first product,
//   2 u |origin - o| + u |o|      of the difference, of the product after it, and of the padded ray,
//   u |plane - o|                 of the sum (or less, where both make one fma),
//   5 u |plane - o|               of a division of 2.5 ulp.
// Let M be the larger magnitude among the faces of all eight boxes along the axis. |origin| and |plane| are at most
// 1.02 M (a margin and one step of 255 beyond the boxes), and q step is at most 2.04 M. The sum is less than 11 u M + 9
// u |o|. The padding of the ray has room for the second term: 20 + 9 < 32. The padding of a box has no room for the
// first, since M belongs to the node and may be much larger than |p|. Planes are therefore moved outward from the boxes
// by exactly kPlaneMargin M = 16 u M. A ray that hits a primitive thus intersects every quantised box around the padded
// box of the primitive, at a distance not greater than that of the hit.
#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>

#include "host/trace/accel/bounds.h"

namespace candela::accel {

inline constexpr std::uint32_t kWideChildren = 8;
/// Distance of the planes of a node from the boxes, as a fraction of the largest coordinate of the node along the axis.
inline constexpr double kPlaneMargin = 0x1p-20;

struct QuantisedBoxes {
  glm::vec3 origin{0};
  std::array<std::int8_t, 3> exponent{};                         ///< exponent of the step along each axis, -100 to 127
  std::array<std::array<std::uint8_t, kWideChildren>, 3> low{};  ///< indices of planes by axis and child
  std::array<std::array<std::uint8_t, kWideChildren>, 3> high{};

  /// Returns the exact coordinate of plane q of an axis.
  double plane(int axis, std::uint32_t q) const;
};

/// `boxes` has up to eight boxes that are proper (see requireProper) or empty, at least one of them not empty. Empty
/// and missing boxes become boxes whose lower planes are above the upper ones; a ray may intersect even these.
QuantisedBoxes quantise(std::span<const Aabb> boxes);

}  // namespace candela::accel

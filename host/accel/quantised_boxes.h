// Eight boxes on a grid of 256 planes an axis, and why no hit is lost to their rounding.
//
// host/accel/primitive_bounds.h pads the box of a primitive with coordinates p by 32 u |p|, and the ray by 32 u |o|,
// with u = 2^-24. Of these a primitive test may use up 20 u (|p| + |o|), and the test of the box itself 8 u (|p| +
// |o|). Kernels test planes of the grid instead:
//
//   t = q * (step * inverse) + (origin - (o +- pad)) * inverse,   plane = origin + q * step,   step a power of two.
//
// Products with the step are exact, so that on each axis t errs, in units of length, by at most
//   u q step                      of the first product,
//   2 u |origin - o| + u |o|      of difference and product behind it, and of the padded ray,
//   u |plane - o|                 of the sum (or less, where both make one fma),
//   5 u |plane - o|               of a division of 2.5 ulp.
// With M the larger magnitude among the faces of all eight boxes along the axis, |origin| and |plane| are at most 1.02
// M (a margin and one step of 255 beyond the boxes) and q step at most 2.04 M. Together that is less than 11 u M + 9 u
// |o|. The ray's pad has room for the second term: 20 + 9 < 32. A box's own pad has none for the first, since M belongs
// to the node and may exceed |p| by far; therefore planes lie kPlaneMargin M = 16 u M outside of the boxes, exactly. So
// a ray that hits a primitive meets every quantised box around the primitive's padded one, and no later than it hits.
#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>

#include "host/accel/bounds.h"

namespace candela::accel {

inline constexpr std::uint32_t kWideChildren = 8;
/// Share of a node's largest coordinate along an axis by which its planes lie outside of the boxes.
inline constexpr double kPlaneMargin = 0x1p-20;

struct QuantisedBoxes {
  glm::vec3 origin{0};
  std::array<std::int8_t, 3> exponent{};                         ///< of the step along each axis, -100 to 127
  std::array<std::array<std::uint8_t, kWideChildren>, 3> low{};  ///< numbers of planes by axis and child
  std::array<std::array<std::uint8_t, kWideChildren>, 3> high{};

  /// Where plane q of an axis lies, exactly.
  double plane(int axis, std::uint32_t q) const;
};

/// `boxes`: up to eight that are proper (see requireProper) or empty, not all of them empty. Empty boxes and those that
/// are not given become boxes whose lower planes are above the upper ones; a ray may meet even these.
QuantisedBoxes quantise(std::span<const Aabb> boxes);

}  // namespace candela::accel

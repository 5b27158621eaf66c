// Chooses a grid for the boxes of a node, and rounds them outward to it.
#include "host/trace/accel/quantised_boxes.h"

#include <algorithm>
#include <cmath>

namespace candela::accel {
namespace {

constexpr int kLastPlane = 255;
constexpr int kMinExponent = -100;  // far above denormals, far below any relevant margin

// Returns the minimum power of two, within range, of which 255 steps cover the extent.
int exponentFor(double reach) {
  int exponent = kMinExponent;
  if (reach > 0) std::frexp(reach / kLastPlane, &exponent);
  return std::max(exponent, kMinExponent);
}

}  // namespace

double QuantisedBoxes::plane(int axis, std::uint32_t q) const {
  return double{origin[axis]} + std::ldexp(static_cast<double>(q), exponent[axis]);
}

QuantisedBoxes quantise(std::span<const Aabb> boxes) {
  Aabb all;
  for (const Aabb& box : boxes) all.extend(box);
  QuantisedBoxes result;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = all.min[axis], high = all.max[axis];
    const double margin = kPlaneMargin * std::max(std::abs(low), std::abs(high));
    result.origin[axis] = roundDown(low - margin);
    const double origin = result.origin[axis];
    result.exponent[axis] = static_cast<std::int8_t>(exponentFor(high + margin - origin));
    const double inverseStep = std::ldexp(1.0, -result.exponent[axis]);
    result.low[axis].fill(kLastPlane);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (boxes[i].isEmpty()) continue;
      const double first = std::floor((boxes[i].min[axis] - margin - origin) * inverseStep);
      const double last = std::ceil((boxes[i].max[axis] + margin - origin) * inverseStep);
      result.low[axis][i] = static_cast<std::uint8_t>(first);
      result.high[axis][i] = static_cast<std::uint8_t>(last);
    }
  }
  return result;
}

}  // namespace candela::accel

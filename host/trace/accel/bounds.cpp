// Checks of bounding boxes.
#include "host/trace/accel/bounds.h"

#include <fmt/format.h>

#include <cmath>

#include "host/base/errors.h"

namespace candela::accel {
namespace {

constexpr float kMaxMagnitude = 0x1p100f;

// The comparisons are written such that they fail for NaN.
bool isProper(const Aabb& b) {
  const bool ordered = b.min.x <= b.max.x && b.min.y <= b.max.y && b.min.z <= b.max.z;
  const bool above = b.min.x >= -kMaxMagnitude && b.min.y >= -kMaxMagnitude && b.min.z >= -kMaxMagnitude;
  const bool below = b.max.x <= kMaxMagnitude && b.max.y <= kMaxMagnitude && b.max.z <= kMaxMagnitude;
  return ordered && above && below;
}

}  // namespace

float roundDown(double x) {
  const float nearest = static_cast<float>(x);
  return double{nearest} <= x ? nearest : std::nextafter(nearest, -INFINITY);
}

void requireProper(const Aabb& box, std::size_t index, const char* structure) {
  if (isProper(box)) return;
  throw InternalError(fmt::format("{} box {} is ({} {} {}) to ({} {} {})", structure, index, box.min.x, box.min.y,
                                  box.min.z, box.max.x, box.max.y, box.max.z));
}

}  // namespace candela::accel

// The box test of quantised boxes in single or double precision, as kernels compute it:
// host/trace/accel/quantised_boxes.h.
#pragma once
#include <cmath>

#include "host/trace/accel/primitive_bounds.h"
#include "host/trace/accel/wide_bvh.h"
#include "tests/trace/accel/ray_tests.h"

namespace candela::test {

using namespace accel;

template <class T>
struct WideRay {
  Vec<T> nearOrigin, farOrigin, inverse;

  explicit WideRay(const Ray<T>& ray) {
    const Vec<T> size = glm::abs(ray.origin);
    const T pad = T{accel::kBoundsPad} * std::max({size.x, size.y, size.z});
    for (int i = 0; i < 3; ++i) {
      const T d = ray.direction[i];
      const bool backward = d < 0;
      nearOrigin[i] = backward ? ray.origin[i] - pad : ray.origin[i] + pad;
      farOrigin[i] = backward ? ray.origin[i] + pad : ray.origin[i] - pad;
      const T magnitude = std::max(std::abs(d), T{0x1p-80f});
      inverse[i] = 1 / (backward ? -magnitude : magnitude);
    }
  }

  /// Returns whether the ray intersects a child's box before `farthest`.
  bool meets(const QuantisedBoxes& boxes, std::uint32_t child, T farthest) const {
    T entry = 0, exit = farthest;
    for (int axis = 0; axis < 3; ++axis) {
      const T step = std::ldexp(T{1}, boxes.exponent[axis]) * inverse[axis];
      const T low = boxes.low[axis][child], high = boxes.high[axis][child];
      const bool backward = inverse[axis] < 0;
      const T near = (backward ? high : low) * step, far = (backward ? low : high) * step;
      entry = std::max(entry, near + (T{boxes.origin[axis]} - nearOrigin[axis]) * inverse[axis]);
      exit = std::min(exit, far + (T{boxes.origin[axis]} - farOrigin[axis]) * inverse[axis]);
    }
    return entry <= exit;
  }
};

}  // namespace candela::test

// Whether vectors are finite.
#pragma once
#include <cmath>
#include <glm/vec3.hpp>

namespace candela {

/// Returns whether no component is infinite or NaN.
template <class T>
bool isFinite(const glm::vec<3, T>& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace candela

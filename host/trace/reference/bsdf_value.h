// The value of a BSDF for a pair of directions.
#pragma once
#include <glm/glm.hpp>

namespace candela::reference {

/// A value of f, and the density per solid angle with which the choice of a lobe and its sampling choose the direction.
struct BsdfValue {
  glm::dvec3 f{0};
  double pdf = 0;
};

}  // namespace candela::reference

// The value of a BSDF for a pair of directions, and its samples without density.
#pragma once
#include <glm/glm.hpp>

#include "host/trace/render/path_record.h"

namespace candela::reference {

/// A value of f, and the density per solid angle with which the choice of a lobe and its sampling choose the direction.
struct BsdfValue {
  glm::dvec3 f{0};
  double pdf = 0;
};

/// A direction without density (mirror, dielectric). `weight` replaces f |cos| / pdf.
struct DeltaSample {
  glm::dvec3 wi;
  glm::dvec3 weight;
  render::Lobe lobe;
};

}  // namespace candela::reference

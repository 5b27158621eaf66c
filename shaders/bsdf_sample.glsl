// A sampled direction in which a path continues.
#ifndef CANDELA_BSDF_SAMPLE_GLSL
#define CANDELA_BSDF_SAMPLE_GLSL
#include "shared/render_data.h"

struct BsdfSample {
  vec3 wi;
  vec3 weight;  // f |cos| / pdf
  float pdf;    // solid angle, whole mixture; 0: delta
  uint lobe;    // kLobe...; kLobeNone: the path ends
};

const BsdfSample kAbsorbed = BsdfSample(vec3(0.0), vec3(0.0), 0.0, kLobeNone);

#endif

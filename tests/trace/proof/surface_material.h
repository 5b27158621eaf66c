// Materials with surfaces, for proofs.
#pragma once
#include "host/scene/material.h"

namespace candela::proof {

/// Refractive indices and extinction coefficients of gold, for red, green and blue light.
inline const scene::Conductor kGold{{0.143f, 0.375f, 1.442f}, {3.983f, 2.386f, 1.603f}};

inline scene::Material materialOf(const scene::SurfaceParameters& surface) {
  scene::Material material;
  material.surface = surface;
  return material;
}

}  // namespace candela::proof

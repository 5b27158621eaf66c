// Queries of materials.
#include "host/scene/material.h"

namespace candela::scene {

MaterialKind kindOf(const Material& material) {
  if (material.surface) return MaterialKind::surface;
  if (material.choice) return MaterialKind::choice;
  if (material.mirror) return MaterialKind::mirror;
  const int count = material.diffuse.has_value() + material.glossy.has_value() + material.dielectric.has_value();
  if (count > 1) return MaterialKind::mixture;
  if (material.diffuse) return MaterialKind::diffuse;
  if (material.glossy) return MaterialKind::glossy;
  return material.dielectric ? MaterialKind::dielectric : MaterialKind::black;
}

}  // namespace candela::scene

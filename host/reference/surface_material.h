// The material at a point of a surface, in the form that the integrators read.
#pragma once
#include "host/reference/bsdf.h"
#include "host/scene/scene.h"

namespace candela::reference {

struct SurfaceMaterial {
  Bsdf bsdf;
  dvec3 emission;  ///< radiance, on both sides
  bool emits;
  std::optional<scene::WhittedMaterial> whitted;

  explicit SurfaceMaterial(const scene::Material& material)
      : bsdf(material), emission(material.emission), emits(isEmissive(material)), whitted(material.whitted) {}
};

}  // namespace candela::reference

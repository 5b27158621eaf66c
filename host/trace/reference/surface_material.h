// The material at a point of a surface, in the form that the integrators read.
#pragma once
#include "host/scene/scene.h"
#include "host/trace/reference/bsdf.h"

namespace candela::reference {

struct SurfaceMaterial {
  Bsdf bsdf;                                        ///< of a material without surface parameters
  std::optional<scene::SurfaceParameters> surface;  ///< the lobes follow from these at every hit
  dvec3 emission;                                   ///< radiance, on both sides
  bool emits;
  bool isCoatAlone = false;  ///< the layers below the coat do not count
  std::optional<scene::WhittedMaterial> whitted;

  /// Multiplies the parameters that the base colour scales.
  void scaleBaseColour(const dvec3& scale) {
    if (surface) surface->baseColour = glm::vec3(dvec3(surface->baseColour) * scale);
    bsdf.scaleBaseColour(scale);
  }
  /// Removes all lobes. The emission stays.
  void makeBlack() {
    surface.reset();
    bsdf = Bsdf(scene::Material{});
  }
  dvec3 albedo() const { return surface ? dvec3(surface->baseColour) : bsdf.albedo(); }

  explicit SurfaceMaterial(const scene::Material& material)
      : bsdf(material),
        surface(material.surface),
        emission(material.emission),
        emits(isEmissive(material)),
        whitted(material.whitted) {}
};

}  // namespace candela::reference

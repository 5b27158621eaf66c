// Reflectances at normal incidence, and their change by a thin film.
#include "host/reference/reflectance.h"

#include "host/reference/fresnel.h"
#include "host/reference/thin_film.h"

namespace candela::reference {
namespace {

dvec3 normalReflectance(const scene::SurfaceParameters& surface) {
  const double ior = surface.ior;
  return glm::min(std::pow((ior - 1) / (ior + 1), 2) * dvec3(surface.specularColour), dvec3(1));
}

// Returns the cosine of the direction outside of the surface to which `wo` belongs.
double outerCosine(const scene::SurfaceParameters& surface, double cosine, bool outside) {
  if (outside || surface.isThinWalled) return cosine;
  const double sine = double{surface.ior} * std::sqrt(std::max(0.0, 1 - cosine * cosine));
  return sine < 1 ? std::sqrt(1 - sine * sine) : 0;
}

}  // namespace

BaseReflectances::BaseReflectances(const scene::SurfaceParameters& surface, const dvec3& wo, bool outside)
    : dielectric{normalReflectance(surface), dvec3(1)}, metal{surface.baseColour, dvec3(1)} {
  if (surface.filmWeight > 0) {
    const ThinFilm film{surface.filmIor, surface.filmThickness};
    const double cosine = outerCosine(surface, wo.z, outside), weight = surface.filmWeight;
    for (Reflectance* base : {&dielectric, &metal}) {
      const dvec3 rise = (1 - weight) * (1.0 - base->normal);
      base->normal = glm::mix(base->normal, film.reflectance(cosine, base->normal), weight);
      base->grazing = base->normal + rise;
    }
  }
  if (const auto& conductor = surface.conductor) {
    const dvec3 base(surface.baseColour);
    metal = base * Reflectance{conductorReflectance(1, conductor->ior, conductor->extinction), dvec3(1)};
  }
}

}  // namespace candela::reference

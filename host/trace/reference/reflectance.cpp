// Reflectances at normal incidence, and their change by a thin film.
#include "host/trace/reference/reflectance.h"

#include "host/trace/reference/fresnel.h"
#include "host/trace/reference/thin_film.h"

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

/// A film that covers the fraction `weight` of a base, seen at a cosine outside of it.
struct Film {
  ThinFilm film;
  double weight;
  double cosine;

  dvec3 reflectanceOver(const dvec3& dimmed) const { return film.reflectance(cosine, dimmed); }
  Reflectance over(const Reflectance& base, double baseWeight) const {
    const dvec3 dimmed = baseWeight * base.normal;
    const dvec3 normal = glm::mix(dimmed, reflectanceOver(dimmed), weight);
    return {normal, normal + (1 - weight) * baseWeight * (1.0 - base.normal)};
  }
};

}  // namespace

BaseReflectances::BaseReflectances(const scene::SurfaceParameters& surface, const dvec3& wo, bool outside)
    : dielectric{normalReflectance(surface), dvec3(1)},
      dielectricWeight(surface.specularWeight),
      dielectricCompensation(dielectric.normal),
      metal{surface.baseColour, dvec3(1)} {
  if (surface.filmWeight > 0 && surface.filmThickness > 0) {
    const Film thin{{surface.filmIor, surface.filmThickness}, surface.filmWeight, outerCosine(surface, wo.z, outside)};
    const dvec3 undimmed = (1 - thin.weight) * (1 - dielectricWeight) * dielectric.normal;
    const dvec3 dimmed = dielectricWeight * dielectric.normal;
    film = {thin.weight, thin.reflectanceOver(dimmed), {(1 - thin.weight) * (largestOf(dimmed) - dimmed), dvec3(0)}};
    dielectric = thin.over(dielectric, dielectricWeight);
    dielectricCompensation = dielectric.normal + undimmed;
    dielectricWeight = 1;
    metal = thin.over(metal, 1);
  }
  if (const auto& conductor = surface.conductor) {
    const dvec3 base(surface.baseColour);
    metal = base * Reflectance{conductorReflectance(1, conductor->ior, conductor->extinction), dvec3(1)};
  }
}

}  // namespace candela::reference

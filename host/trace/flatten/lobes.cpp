// Computes the lobes of a material.
#include "host/trace/flatten/lobes.h"

namespace candela::flatten {
namespace {

Lobes lobesOf(const scene::Material& material) {
  Lobes lobes;
  if (material.diffuse) {
    lobes.diffuse = material.diffuse->weight;
    lobes.diffuseColour = material.diffuse->colour;
  }
  if (material.glossy) {
    lobes.glossy = material.glossy->weight;
    lobes.glossyColour = material.glossy->colour;
    lobes.exponent = material.glossy->exponent;
  }
  if (material.dielectric) {
    lobes.dielectric = material.dielectric->weight;
    lobes.specularColour = material.dielectric->colour;
    lobes.ior = material.dielectric->ior;
  }
  if (material.mirror) {
    lobes.mirror = true;
    lobes.specularColour = material.mirror->colour;
  }
  return lobes;
}

Lobes lobesOf(const scene::WhittedMaterial& material) {
  return {.diffuse = material.kd,
          .glossy = material.ks,
          .dielectric = material.kind == scene::WhittedKind::glass ? 1.0 : 0.0,
          .mirror = material.kind == scene::WhittedKind::mirror,
          .diffuseColour = material.diffuse,
          .glossyColour = material.specular,
          .exponent = material.shine,
          .ior = material.ior};
}

}  // namespace

Lobes lobesFor(render::Integrator integrator, const scene::Material& material) {
  return integrator == render::Integrator::whitted ? lobesOf(material.whitted.value()) : lobesOf(material);
}

bool transmits(render::Integrator integrator, const scene::Material& material) {
  const bool refracts = material.surface && material.surface->transmissionWeight > 0;
  return refracts || lobesFor(integrator, material).dielectric > 0;
}

glm::dvec3 ownRadiance(render::Integrator integrator, const scene::Material& material) {
  const glm::dvec3 emission(material.emission);
  if (integrator != render::Integrator::whitted) return emission;
  const scene::WhittedMaterial& whitted = material.whitted.value();
  return emission + double{whitted.ka} * glm::dvec3(whitted.diffuse);
}

}  // namespace candela::flatten

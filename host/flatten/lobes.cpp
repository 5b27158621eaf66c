// Computes the lobes of a material.
#include "host/flatten/lobes.h"

namespace candela::flatten {

Lobes lobesOf(const scene::Material& material) {
  if (material.kd == 1) return {.diffuse = 1};
  if (material.ks == 1) return {.mirror = true};
  const double transmitted = material.ior > 0 ? 1 : 0;
  if (material.kd == 0 && material.ks == 0) return {.dielectric = transmitted};
  const double sum = double{material.kd} + double{material.ks} + double{material.t};
  const double scale = sum > 1 ? 1 / sum : 1;
  return {
      .diffuse = material.kd * scale, .glossy = material.ks * scale, .dielectric = material.t * scale * transmitted};
}

Lobes whittedLobesOf(const scene::Material& material) {
  const bool glass = material.t > 0 && material.ior > 0;
  return {.diffuse = material.kd,
          .glossy = material.ks,
          .dielectric = glass ? 1.0 : 0.0,
          .mirror = material.t == 0 && material.ks > 0};
}

Lobes lobesFor(render::Integrator integrator, const scene::Material& material) {
  return integrator == render::Integrator::whitted ? whittedLobesOf(material) : lobesOf(material);
}

glm::dvec3 ownRadiance(render::Integrator integrator, const scene::Material& material) {
  const glm::dvec3 emission(material.emission);
  if (integrator != render::Integrator::whitted) return emission;
  return emission + double{material.ka} * glm::dvec3(material.diffuse);
}

}  // namespace candela::flatten

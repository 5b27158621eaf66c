// The lobes of a material in the format of the device's records: those of the path tracer, or those of the Whitted
// tracer.
#pragma once
#include "host/scene/scene.h"
#include "host/trace/render/settings.h"

namespace candela::flatten {

/// A lobe of weight 0 does not exist.
struct Lobes {
  double diffuse = 0;
  double glossy = 0;
  double dielectric = 0;
  bool mirror = false;
  glm::dvec3 diffuseColour{0};
  glm::dvec3 glossyColour{0};
  glm::dvec3 specularColour{0};  ///< of the dielectric or of the mirror
  double exponent = 0;           ///< of the glossy lobe
  double ior = 1;                ///< of the dielectric
};

/// Returns the lobes. For the Whitted tracer, the weights are Kd, Ks, and 1 for glass; a mirror has Ks as its factor.
Lobes lobesFor(render::Integrator integrator, const scene::Material& material);
/// Returns whether rays may cross a surface of the material.
bool transmits(render::Integrator integrator, const scene::Material& material);
/// Returns the radiance of a surface without any light: its emission and, with the Whitted tracer, its ambient term.
glm::dvec3 ownRadiance(render::Integrator integrator, const scene::Material& material);

}  // namespace candela::flatten

// The rules that turn an `f` line into what an integrator makes of it: docs/light-transport.md sections 5 and 9.
#pragma once
#include "host/render/settings.h"
#include "host/scene/scene.h"

namespace candela::flatten {

/// Weights sum to at most 1; all 0: the surface is black. A mirror has weights 0 and takes `diffuse` as its colour.
struct Lobes {
  double diffuse = 0;
  double glossy = 0;
  double dielectric = 0;
  bool mirror = false;
};

Lobes lobesOf(const scene::Material& material);

/// As Whitted's tracer reads the line: Kd, Ks, 1 if it is glass, and whether it is a mirror, which takes Ks as its
/// factor.
Lobes whittedLobesOf(const scene::Material& material);

/// Of the integrator that is used.
Lobes lobesFor(render::Integrator integrator, const scene::Material& material);
/// What a surface shows without any light: its emission, and with Whitted's tracer its ambient share.
glm::dvec3 ownRadiance(render::Integrator integrator, const scene::Material& material);

}  // namespace candela::flatten

// Which of the kernel's features a scene uses.
#pragma once
#include "host/flatten/flat_scene.h"

namespace candela::flatten {

/// All but the kinds of lights, which the light table tells.
SceneFeatures featuresOf(const scene::Scene& scene, render::Integrator integrator);

}  // namespace candela::flatten

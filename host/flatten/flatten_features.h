// Determines which of the kernel's features a scene uses.
#pragma once
#include "host/flatten/flat_scene.h"

namespace candela::flatten {

/// Returns all features except the kinds of lights, which follow from the light table.
SceneFeatures featuresOf(const scene::Scene& scene, render::Integrator integrator);

}  // namespace candela::flatten

// Which of the kernel's features a scene uses.
#pragma once
#include "host/render/flat_scene.h"

namespace candela {

/// All but the kinds of lights, which the light table tells.
SceneFeatures featuresOf(const Scene& scene, Integrator integrator);

}  // namespace candela

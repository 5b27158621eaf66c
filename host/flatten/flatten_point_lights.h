// Rows of the lights of Whitted's tracer.
#pragma once
#include "host/flatten/flat_rows.h"
#include "host/scene/scene.h"

namespace candela::flatten {

/// All point lights in file order, as squares of side `size` (0: points) that face the camera's `at`: see
/// docs/light-transport.md section 9 and shaders/shared/scene_rows.h. The scene has a camera.
Rows pointLightRows(const scene::Scene& scene, double size);

}  // namespace candela::flatten

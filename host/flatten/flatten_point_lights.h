// Stores the lights of the Whitted tracer as 16-byte records.
#pragma once
#include <span>

#include "host/flatten/flat_rows.h"
#include "host/scene/scene.h"

namespace candela::flatten {

/// Returns the records of all point lights in the given order, as squares of side `size` (0: points) that face the
/// camera's target: see docs/light-transport.md section 9 and shaders/shared/scene_rows.h.
Rows pointLightRows(std::span<const scene::PointLight> lights, const scene::Camera& camera, double size);

}  // namespace candela::flatten

// Measures of a scene by which the flux of its lights is estimated: docs/light-transport.md section 6.
#pragma once
#include "host/scene/scene.h"

namespace candela::reference {

/// Returns the square of half the diagonal of the box around all primitives except planes; 0 if there are none.
double squaredRadius(const scene::Scene& scene);

/// Returns the mean luminance of all directions.
double meanLuminance(const scene::Environment& environment);

}  // namespace candela::reference

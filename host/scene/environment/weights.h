// The integer weights by which the texels of an environment are chosen.
#pragma once
#include "host/scene/environment.h"

namespace candela::environment {

/// Returns the solid angle of each texel of a row, up to a factor that all rows of the map share.
double solidAngleOfRow(const scene::Environment& environment, std::uint32_t row);

/// Sets the weights in proportion to luminance times solid angle.
void setWeights(scene::Environment& environment);

}  // namespace candela::environment

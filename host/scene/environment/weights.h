// The integer weights by which the texels of an environment are chosen.
#pragma once
#include "host/scene/environment.h"

namespace candela::environment {

/// Sets the weights in proportion to luminance times solid angle.
void setWeights(scene::Environment& environment);

}  // namespace candela::environment

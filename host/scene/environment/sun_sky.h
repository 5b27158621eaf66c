// The environment "sun:ELEVATION,AZIMUTH,TURBIDITY".
#pragma once
#include <string_view>

#include "host/scene/environment.h"

namespace candela::environment {

/// Returns the map of a sky with its sun over grey ground, in the units of docs/gltf.md; weights and axes are not set.
/// `numbers` is "ELEVATION,AZIMUTH,TURBIDITY": degrees above the horizon, from 0 to 90; degrees clockwise, seen from
/// above, from the direction -z of the map, from -360 to 360; and 2 to 10. Throws UsageError.
scene::Environment makeSunSky(std::string_view numbers);

}  // namespace candela::environment

// Directions of an environment map, and its placement in a scene.
#pragma once
#include "host/scene/environment.h"

namespace candela::environment {

/// Returns the direction, in the frame of the map, of a point of a map of the given size in texels: x from the left, y
/// from the top.
glm::dvec3 directionOf(double x, double y, std::uint32_t width, std::uint32_t height);

/// Sets the axes so that the map's y axis is `up` (a unit vector along a coordinate axis), and the map is rotated about
/// it by `degrees`, counterclockwise seen from above. With `up` = y and 0 degrees, the axes are those of the scene;
/// with `up` = z, the map's axes x, y, z are the scene's x, z, -y.
void place(scene::Environment& environment, const glm::vec3& up, double degrees);

}  // namespace candela::environment

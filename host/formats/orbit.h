// Turns a view about its target, for turntables.
#pragma once
#include "host/scene/scene.h"

namespace candela::formats {

/// Returns the scene's camera, which it must have, turned by an angle about the axis through its target that is
/// parallel to Scene::up: counterclockwise, seen from above. Lights and environment stay in place. The position and the
/// direction `up` are computed in double precision, and rounded once.
scene::Camera orbitedCamera(const scene::Scene& scene, double degrees);

}  // namespace candela::formats

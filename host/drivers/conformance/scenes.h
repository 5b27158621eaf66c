// The scenes of the pictures, by name.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "host/scene/scene.h"

namespace candela::conformance {

/// Names of materials, most of them of glTF. The scene of each is a ball of this material on a floor, or the floor has
/// what the name states.
std::vector<std::string_view> materialNames();

/// Returns the scene: "cornell", "primitives" or "depth_of_field" of scenes/, "terrain" (a mesh), or a name of
/// materialNames(). A scene is made once in a process. Throws InternalError for any other name.
const scene::Scene& sceneNamed(const std::string& name);

}  // namespace candela::conformance

// The box around everything in a scene that is bounded.
#pragma once
#include <functional>
#include <optional>

#include "host/scene/scene.h"

namespace candela::scene {

struct Bounds {
  glm::vec3 min;
  glm::vec3 max;
};

/// Returns the bounds of all primitives except infinite planes, or of those of the runs that `includes` accepts;
/// nothing if there are none.
std::optional<Bounds> boundsOf(const Scene& scene, const std::function<bool(const PrimitiveRun&)>& includes = {});

}  // namespace candela::scene

// The box around everything in a scene that is bounded.
#pragma once
#include <optional>

#include "host/scene/scene.h"

namespace candela::scene {

struct Bounds {
  glm::vec3 min;
  glm::vec3 max;
};

/// Returns the bounds of all primitives except infinite planes; nothing if there are no others.
std::optional<Bounds> boundsOf(const Scene& scene);

}  // namespace candela::scene

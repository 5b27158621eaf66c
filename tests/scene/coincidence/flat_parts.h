// The flat surfaces of a scene, for comparisons of all pairs.
#pragma once
#include <vector>

#include "host/scene/coincidence/flat_surface.h"
#include "host/scene/shape.h"

namespace candela::test {

/// Returns the flat parts of the primitives for which `includes(primitive)` is true.
template <class Includes>
std::vector<scene::FlatSurface> flatPartsOf(const scene::Scene& scene, const Includes& includes) {
  std::vector<scene::FlatSurface> parts;
  for (std::uint32_t i = 0; i < scene.primitives.size(); ++i) {
    if (!includes(i)) continue;
    std::vector<scene::FlatSurface> own(scene::flatPartCount(scene.primitives[i].kind));
    const std::size_t count = scene::storeFlatParts(shapeOf(scene, scene.primitives[i]), i, own);
    parts.insert(parts.end(), own.begin(), own.begin() + static_cast<std::ptrdiff_t>(count));
  }
  return parts;
}

}  // namespace candela::test

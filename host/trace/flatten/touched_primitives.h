// Primitives whose surface may contain a light: docs/light-transport.md section 6, "Lights that touch surfaces". The
// device tests the others no further, and a scene without any has kernels without this test.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "host/scene/scene.h"
#include "host/trace/flatten/light_table.h"
#include "host/trace/render/settings.h"

namespace candela::flatten {

/// A triangle that emits.
struct EmitterPosition {
  std::uint32_t primitive;
  std::array<glm::dvec3, 3> vertices;
};

/// Positions of the lights that have a margin.
struct LightPositions {
  std::vector<glm::dvec3> points;
  double slack = 0;  ///< maximum distance of a sampled point from its position
  std::vector<EmitterPosition> triangles;
};

/// Returns the lights of the table or, for the Whitted tracer, the point lights; none for views, whose rays do not end
/// at lights.
LightPositions lightPositions(const scene::Scene& scene, std::span<const LightEntry> table,
                              const render::ImageSettings& image);

/// Returns by number in scene::StoredPrimitives whether a primitive may contain a light other than itself, in some
/// instance if it belongs to instances. This is judged by twice the margin. A triangle that emits counts if all of it
/// lies on the surface and the interiors overlap: otherwise a sampled point lies within the rounding of the surface
/// with a probability of about 10^-6. The result holds for every position of the camera. If lights and primitives are
/// too many to be compared, it is true for all.
std::vector<bool> touchedPrimitives(const scene::Scene& scene, const LightPositions& lights);

}  // namespace candela::flatten

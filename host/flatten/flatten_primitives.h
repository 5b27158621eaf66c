// Rows of primitives and of vertex normals.
#pragma once
#include <cstdint>
#include <span>

#include "host/flatten/flat_rows.h"
#include "host/scene/scene.h"

namespace candela::flatten {

/// What flatten knows about a primitive beyond the scene's own entry.
struct PrimitiveContext {
  std::uint32_t primitive = 0;  ///< index in Scene::primitives
  std::uint32_t light = 0;      ///< place in the light table + 1; 0: not in it
};

/// Sets what depends on the eye in the first two rows of a sphere: the anchor and the unit vector there from the
/// centre.
void placeSphere(const scene::Sphere& sphere, const glm::vec3& eye, std::span<gpu::uvec4, 2> rows);

/// Appends the rows of one primitive to `primitives`, and those of its vertex normals, if it has any, to `normals`.
/// A smooth triangle refers to `normals` by row within that section.
void appendPrimitive(const scene::Scene& scene, const PrimitiveContext& context, Rows& primitives, Rows& normals);

}  // namespace candela::flatten

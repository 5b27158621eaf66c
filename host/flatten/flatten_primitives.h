// Stores primitives and the attributes of vertices as 16-byte records.
#pragma once
#include <cstdint>
#include <span>

#include "host/flatten/flat_rows.h"
#include "host/scene/scene.h"

namespace candela::flatten {

/// Data about a primitive that its entry in the scene does not contain.
struct PrimitiveContext {
  std::uint32_t primitive = 0;  ///< index in Scene::primitives
  std::uint32_t light = 0;      ///< index in the light table + 1; 0: not in it
  bool touched = false;         ///< the surface may contain a light: touched_primitives.h
  bool keepsTexCoords = false;  ///< even if no texture needs the texture coordinates
};

/// Sets the parts of a sphere's first two records that depend on the eye: the anchor, and the unit vector from the
/// centre to the anchor.
void placeSphere(const scene::Sphere& sphere, const glm::vec3& eye, std::span<gpu::uvec4, 2> rows);

/// Appends the records of one primitive to `primitives`, and those of its vertices' attributes, if it has any, to
/// `attributes`. A triangle refers to `attributes` by the index of a record within that section.
void appendPrimitive(const scene::Scene& scene, const PrimitiveContext& context, Rows& primitives, Rows& attributes);

}  // namespace candela::flatten

// Triangles that rays may pass: docs/light-transport.md section 12.
#pragma once
#include <cstdint>

#include "host/scene/scene.h"
#include "host/trace/reference/ray.h"
#include "host/trace/reference/texture.h"

namespace candela::reference {

/// Returns the key of the decisions of one ray: that of a path's vertex, or the shadow ray from there.
std::uint32_t opacityKey(std::uint32_t pixel, std::uint32_t sample, std::uint32_t seed, std::uint32_t vertex,
                         bool isShadowRay);

/// Returns whether rays may pass a primitive.
bool isTransparent(const scene::Scene& scene, const scene::Primitive& primitive);

/// Returns the probability with which a ray hits a point of a triangle for which isTransparent() is true. `jitter`
/// selects the texel of a material that blends, and `st` are the coordinates in the texture of its opacity, if it has
/// one.
double opacityAt(const scene::Scene& scene, const scene::Primitive& triangle, const MeshAttributes& attributes,
                 const dvec2& st, const dvec2& jitter);

/// Returns whether a ray hits a triangle for which isTransparent() is true, and which its intersection test has found.
bool isThere(const scene::Scene& scene, std::uint32_t primitive, const Ray& ray);
/// Returns the same for the triangle's attributes at the hit, and the coordinates of opacityAt() there.
bool isThere(const scene::Scene& scene, std::uint32_t primitive, const Ray& ray, const MeshAttributes& attributes,
             const dvec2& st);
/// Returns the attributes of such a triangle at the hit.
MeshAttributes attributesAtHit(const scene::Scene& scene, std::uint32_t primitive, const Ray& ray);

}  // namespace candela::reference

// Computes the mean factor that the texture and the vertex colours of an emitter apply to its emission.
#pragma once
#include "host/scene/scene.h"

namespace candela::scene {

/// Returns the mean of the texels of the emission, decoded, times the vertex colours that scale it, at the centres of
/// the 64 congruent triangles into which a primitive that is a triangle is divided: docs/light-transport.md section 11.
/// 1 if there are neither.
glm::dvec3 meanEmissionTexel(const Scene& scene, const Primitive& triangle);

}  // namespace candela::scene

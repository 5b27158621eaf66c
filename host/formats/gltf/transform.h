// Places meshes in the scene.
#pragma once
#include <glm/glm.hpp>

#include "host/formats/gltf/geometry.h"

namespace candela::gltf {

/// Applies an affine transform to positions, normals and tangents, in double precision. A transform that mirrors
/// reverses the order of vertices, so that fronts stay fronts, and the handedness of tangents. Normals and tangents get
/// unit length. A normal of length 0 is replaced by that of a triangle at its vertex. Throws JsonError at `source` if
/// a position is then beyond the range of binary32.
void place(scene::Mesh& mesh, const glm::dmat4& transform, const Value& source);

/// The same with a transform for each vertex: the mean of its joints' matrices by weight, as in section 3.7.3 of
/// the specification. Weights that do not sum to 1 are scaled.
void placeSkinned(scene::Mesh& mesh, const Influences& influences, std::span<const glm::dmat4> joints,
                  const Value& source);

}  // namespace candela::gltf

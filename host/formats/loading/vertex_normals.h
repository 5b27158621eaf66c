// Normals of vertices as Scene has them, from those of files.
#pragma once
#include <glm/glm.hpp>

#include "host/scene/mesh.h"

namespace candela::scene {

/// Returns the unit vector along v; 0 for v = 0 and for lengths that overflow.
glm::vec3 unitNormalOrZero(const glm::dvec3& v);

/// Replaces vertex normals of length 0 by the normal of the first triangle at the vertex, of a mesh with indices. Those
/// of vertices whose triangles have no area become (0, 0, 1).
void replaceZeroNormals(Mesh& mesh);

}  // namespace candela::scene

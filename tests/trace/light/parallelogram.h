// A mesh with texture coordinates.
#pragma once
#include <glm/glm.hpp>

#include "host/scene/scene.h"

namespace candela::test {

/// A parallelogram, counter-clockwise from its front, with texture coordinates from 0 to 1 along u and along v.
inline scene::Mesh parallelogram(const glm::vec3& corner, const glm::vec3& u, const glm::vec3& v) {
  scene::Mesh mesh;
  mesh.positions = {corner, corner + u, corner + u + v, corner + v};
  mesh.texCoords[0] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.indices = {0, 1, 2, 0, 2, 3};
  return mesh;
}

}  // namespace candela::test

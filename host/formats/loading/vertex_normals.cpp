// Normalises vertex normals.
#include "host/formats/loading/vertex_normals.h"

#include <algorithm>
#include <cmath>

namespace candela::scene {

glm::vec3 unitNormalOrZero(const glm::dvec3& v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (largest == 0 || !std::isfinite(largest)) return glm::vec3(0);
  return glm::vec3(glm::normalize(v / largest));
}

void replaceZeroNormals(Mesh& mesh) {
  if (std::ranges::find(mesh.normals, glm::vec3(0)) == mesh.normals.end()) return;
  const std::size_t count = mesh.indices.size();
  for (std::size_t i = 0; i + 2 < count; i += 3) {
    const std::uint32_t* const corner = &mesh.indices[i];
    bool isComplete = true;
    for (std::size_t c = 0; c < 3; ++c) isComplete = isComplete && mesh.normals[corner[c]] != glm::vec3(0);
    if (isComplete) continue;
    const glm::dvec3 p0(mesh.positions[corner[0]]);
    const glm::vec3 normal = unitNormalOrZero(
        glm::cross(glm::dvec3(mesh.positions[corner[1]]) - p0, glm::dvec3(mesh.positions[corner[2]]) - p0));
    for (std::size_t c = 0; c < 3; ++c) {
      if (mesh.normals[corner[c]] == glm::vec3(0)) mesh.normals[corner[c]] = normal;
    }
  }
  for (glm::vec3& normal : mesh.normals) {
    if (normal == glm::vec3(0)) normal = glm::vec3(0, 0, 1);  // of a triangle without area, which is never hit
  }
}

}  // namespace candela::scene

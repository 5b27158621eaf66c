// Appends corners of their own to each face, so that edges stay sharp.
#include "host/scene/generate/flat_shapes.h"

#include <initializer_list>

namespace candela::generate {

using glm::dvec3;

void appendQuad(TriangleMesh& mesh, const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& d) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const dvec3 normal = normalize(cross(c - a, d - b));
  for (const dvec3& corner : {a, b, c, d}) {
    mesh.positions.emplace_back(corner);
    mesh.normals.emplace_back(normal);
  }
  mesh.indices.insert(mesh.indices.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
}

void appendTriangle(TriangleMesh& mesh, const dvec3& a, const dvec3& b, const dvec3& c) {
  const glm::vec3 normal(normalize(cross(b - a, c - a)));
  for (const dvec3& corner : {a, b, c}) {
    mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
    mesh.positions.emplace_back(corner);
    mesh.normals.push_back(normal);
  }
}

void appendBox(TriangleMesh& mesh, const dvec3& low, const dvec3& high) {
  const auto at = [&](int x, int y, int z) {
    return dvec3(x == 0 ? low.x : high.x, y == 0 ? low.y : high.y, z == 0 ? low.z : high.z);
  };
  appendQuad(mesh, at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1));
  appendQuad(mesh, at(1, 0, 0), at(0, 0, 0), at(0, 1, 0), at(1, 1, 0));
  appendQuad(mesh, at(1, 0, 1), at(1, 0, 0), at(1, 1, 0), at(1, 1, 1));
  appendQuad(mesh, at(0, 0, 0), at(0, 0, 1), at(0, 1, 1), at(0, 1, 0));
  appendQuad(mesh, at(0, 1, 1), at(1, 1, 1), at(1, 1, 0), at(0, 1, 0));
  appendQuad(mesh, at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1));
}

}  // namespace candela::generate

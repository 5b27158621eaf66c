// Triangle meshes, with or without indices, and their triangles.
#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace candela::scene {

/// Vertex attributes, one array each, and the triangles over them. An attribute's array is empty, or has one element
/// for each vertex. Triangle t has the vertices indices[3 t], indices[3 t + 1] and indices[3 t + 2], in this order
/// counter-clockwise from its front. Without indices it has the vertices 3 t, 3 t + 1 and 3 t + 2.
struct Mesh {
  std::vector<glm::vec3> positions{};                 ///< never empty
  std::vector<glm::vec3> normals{};                   ///< of unit length
  std::array<std::vector<glm::vec2>, 2> texCoords{};  ///< two sets
  std::vector<glm::vec4> tangents{};     ///< unit vector; w, 1 or -1: the bitangent is w cross(normal, tangent)
  std::vector<glm::vec4> colours{};      ///< linear RGBA
  std::vector<std::uint32_t> indices{};  ///< into the attributes, three for each triangle; may be empty

  bool operator==(const Mesh&) const = default;
};

/// The positions of one triangle's vertices.
struct Triangle {
  glm::vec3 p[3];
};

/// The normals at one triangle's vertices.
struct VertexNormals {
  glm::vec3 n[3];
};

inline std::size_t triangleCount(const Mesh& mesh) {
  return (mesh.indices.empty() ? mesh.positions.size() : mesh.indices.size()) / 3;
}

/// Returns the index of vertex `corner` (0 to 2) of a triangle.
inline std::size_t vertexIndex(const Mesh& mesh, std::uint32_t triangle, std::uint32_t corner) {
  const std::size_t place = std::size_t{3} * triangle + corner;
  return mesh.indices.empty() ? place : mesh.indices[place];
}

/// Returns the values of an attribute, which must not be empty, at one triangle's vertices.
template <class Value>
std::array<Value, 3> attributeOf(const Mesh& mesh, const std::vector<Value>& attribute, std::uint32_t triangle) {
  return {attribute[vertexIndex(mesh, triangle, 0)], attribute[vertexIndex(mesh, triangle, 1)],
          attribute[vertexIndex(mesh, triangle, 2)]};
}

}  // namespace candela::scene

// Splits vertices by their tangents.
#include "host/formats/gltf/tangents.h"

#include "host/formats/loading/mikk_tangents.h"

namespace candela::gltf {
namespace {

template <class Element>
void repeat(std::vector<Element>& attribute, std::size_t vertex) {
  if (attribute.empty()) return;
  const Element value = attribute[vertex];
  attribute.push_back(value);
}

/// Appends a copy of a vertex, apart from its tangent.
void repeatVertex(Geometry& geometry, std::size_t vertex) {
  scene::Mesh& mesh = geometry.mesh;
  repeat(mesh.positions, vertex);
  repeat(mesh.normals, vertex);
  repeat(mesh.colours, vertex);
  for (auto& set : mesh.texCoords) repeat(set, vertex);
  for (auto& set : geometry.influences.joints) repeat(set, vertex);
  for (auto& set : geometry.influences.weights) repeat(set, vertex);
}

}  // namespace

void addTangents(Geometry& geometry, const scene::TextureReference& texture) {
  scene::Mesh& mesh = geometry.mesh;
  const std::vector<glm::vec4> corners = scene::mikkTangents(mesh, texture);
  mesh.tangents.assign(mesh.positions.size(), glm::vec4(0));  // w is 0 until a triangle sets the tangent
  std::vector<std::uint32_t> nextCopy(mesh.positions.size(), 0);
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    std::uint32_t vertex = mesh.indices[i];
    while (mesh.tangents[vertex].w != 0 && mesh.tangents[vertex] != corners[i] && nextCopy[vertex] != 0) {
      vertex = nextCopy[vertex];
    }
    if (mesh.tangents[vertex].w != 0 && mesh.tangents[vertex] != corners[i]) {
      nextCopy[vertex] = static_cast<std::uint32_t>(mesh.positions.size());
      repeatVertex(geometry, vertex);
      vertex = nextCopy[vertex];
      nextCopy.push_back(0);
      mesh.tangents.emplace_back(0);
    }
    mesh.tangents[vertex] = corners[i];
    mesh.indices[i] = vertex;
  }
}

}  // namespace candela::gltf

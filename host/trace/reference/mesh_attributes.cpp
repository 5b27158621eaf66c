// Texture coordinates, tangents and colours of a mesh, interpolated over a triangle.
#include "host/trace/reference/mesh_attributes.h"

namespace candela::reference {
namespace {

// Handedness is the same at the three vertices of a triangle.
void setTangents(const std::array<glm::vec4, 3>& tangents, const glm::dvec2& b, const dvec3& normal,
                 MeshAttributes& attributes) {
  const auto mean = interpolate<glm::dvec4>(tangents, b);
  const double length = glm::length(dvec3(mean));
  if (length == 0) return;
  attributes.tangent = dvec3(mean) / length;
  attributes.bitangent = double{tangents[0].w} * cross(normal, attributes.tangent);
}

}  // namespace

MeshAttributes attributesAt(const scene::Scene& scene, const scene::Primitive& triangle, const glm::dvec2& b,
                            const dvec3& normal) {
  const scene::Mesh& mesh = meshOf(scene, triangle);
  MeshAttributes attributes;
  for (std::size_t set = 0; set < mesh.texCoords.size(); ++set) {
    if (mesh.texCoords[set].empty()) continue;
    const auto corners = attributeOf(mesh, mesh.texCoords[set], triangle.index);
    attributes.texCoords[set] = interpolate<glm::dvec2>(corners, b);
    for (const glm::vec2& corner : corners) {
      attributes.texCoordScale[set] = glm::max(attributes.texCoordScale[set], glm::abs(glm::dvec2(corner)));
    }
  }
  if (!mesh.colours.empty()) {
    attributes.colour = interpolate<glm::dvec4>(attributeOf(mesh, mesh.colours, triangle.index), b);
  }
  if (!mesh.tangents.empty()) setTangents(vertexTangentsOf(scene, triangle), b, normal, attributes);
  return attributes;
}

}  // namespace candela::reference

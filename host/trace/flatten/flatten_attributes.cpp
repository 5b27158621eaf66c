// Stores the attributes of triangles' vertices as 16-byte records.
#include "host/trace/flatten/flatten_primitives.h"

namespace candela::flatten {
namespace {

void appendNormals(const scene::VertexNormals& normals, std::uint32_t light, Rows& rows) {
  rows.push_back(row(glm::dvec3(normals.n[0]), light));
  rows.push_back(row(glm::dvec3(normals.n[1]), 0u));
  rows.push_back(row(glm::dvec3(normals.n[2]), 0u));
}

// Coordinates that a mesh lacks are 0.
void appendTexCoords(const scene::Mesh& mesh, std::uint32_t triangle, Rows& rows) {
  for (std::uint32_t corner = 0; corner < 3; ++corner) {
    const std::size_t vertex = vertexIndex(mesh, triangle, corner);
    gpu::uvec4 words(0);
    for (int set = 0; set < 2; ++set) {
      const std::vector<glm::vec2>& coords = mesh.texCoords[static_cast<std::size_t>(set)];
      if (coords.empty()) continue;
      words[2 * set] = floatBits(double{coords[vertex].x});
      words[2 * set + 1] = floatBits(double{coords[vertex].y});
    }
    rows.push_back(words);
  }
}

void appendVectors(const std::array<glm::vec4, 3>& values, Rows& rows) {
  for (const glm::vec4& value : values) {
    rows.push_back(row(glm::dvec3(value), double{value.w}));
  }
}

}  // namespace

std::size_t attributeRowsOf(const SceneFeatures& features) {
  constexpr std::size_t kVectorRows = 3;  // of colours and of tangents
  const std::size_t coordinates = features.textures ? gpu::kTexCoordRows : 0;
  const std::size_t vectors = kVectorRows * (std::size_t{features.colours} + std::size_t{features.tangents});
  return features.smooth || coordinates + vectors > 0 ? gpu::kNormalRows + coordinates + vectors : 0;
}

std::uint32_t attributeFlags(const scene::Scene& scene, const PrimitiveContext& context,
                             const scene::Primitive& triangle) {
  const scene::Material& material = scene.materials[triangle.material];
  const bool hasTexture = isTextured(material) || (material.opacity && material.opacity->texture);
  const bool isMapped = hasTexture || (context.keepsTexCoords && !meshOf(scene, triangle).texCoords[0].empty());
  return (isSmooth(scene, triangle) ? gpu::kFlagSmooth : 0) | (isMapped ? gpu::kFlagTexCoords : 0) |
         (meshOf(scene, triangle).colours.empty() ? 0 : gpu::kFlagColours) |
         (hasTangents(scene, triangle) ? gpu::kFlagTangents : 0) |
         (coloursOfEmission(scene, triangle) ? gpu::kFlagEmissionColours : 0);
}

void appendAttributes(const scene::Scene& scene, const PrimitiveContext& context, const scene::Primitive& triangle,
                      std::uint32_t flags, Rows& rows) {
  if (flags & gpu::kFlagSmooth) {
    appendNormals(vertexNormalsOf(scene, triangle), context.light, rows);
  } else {
    rows.push_back({context.light, 0, 0, 0});
  }
  const scene::Mesh& mesh = meshOf(scene, triangle);
  if (flags & gpu::kFlagTexCoords) appendTexCoords(mesh, triangle.index, rows);
  if (flags & gpu::kFlagColours) appendVectors(attributeOf(mesh, mesh.colours, triangle.index), rows);
  if (flags & gpu::kFlagTangents) appendVectors(vertexTangentsOf(scene, triangle), rows);
}

}  // namespace candela::flatten

// Compares the geometry of primitives, and mirrors meshes.
#include "host/formats/gltf/shared_mesh.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

namespace candela::gltf {

std::string geometryKey(const Value& primitive, std::span<const double> weights,
                        const std::optional<scene::TextureReference>& tangentTexture) {
  nlohmann::json geometry = primitive.json();
  geometry.erase("material");
  if (const auto extensions = geometry.find("extensions"); extensions != geometry.end() && extensions->is_object()) {
    extensions->erase("KHR_materials_variants");
  }
  std::string key = fmt::format("{} {}", geometry.dump(), fmt::join(weights, " "));
  if (!tangentTexture) return key;
  const glm::vec3& s = tangentTexture->rowS;
  const glm::vec3& t = tangentTexture->rowT;
  return key + fmt::format(" {} {} {} {} {} {} {}", tangentTexture->texCoordSet, s.x, s.y, s.z, t.x, t.y, t.z);
}

scene::Mesh mirroredMesh(scene::Mesh mesh) {
  for (std::size_t corner = 0; corner + 2 < mesh.indices.size(); corner += 3) {
    std::swap(mesh.indices[corner + 1], mesh.indices[corner + 2]);
  }
  for (glm::vec4& tangent : mesh.tangents) tangent.w = -tangent.w;
  return mesh;
}

glm::dvec3 reachOf(const scene::Mesh& mesh) {
  glm::dvec3 reach(0);
  for (const glm::vec3& point : mesh.positions) reach = glm::max(reach, glm::abs(glm::dvec3(point)));
  return reach;
}

float minAlphaOf(const scene::Mesh& mesh) {
  float minAlpha = 1;
  for (const glm::vec4& colour : mesh.colours) minAlpha = std::min(minAlpha, colour.w);
  return minAlpha;
}

}  // namespace candela::gltf

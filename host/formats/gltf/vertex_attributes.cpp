// Reads the attributes of vertices, of which colours and influences are not stored as they are used.
#include "host/formats/gltf/vertex_attributes.h"

#include <fmt/format.h>

namespace candela::gltf {
namespace {

std::vector<glm::vec4> readColours(const VertexSource& source, const Vertices& vertices) {
  const std::optional<Value> reference = source.attribute("COLOR_0");
  if (!reference) return {};
  if (source.components(*reference, "COLOR_0") == 4)
    return source.read<glm::vec4>("COLOR_0", vertices.count, vertices.selection);
  const std::vector<glm::vec3> opaque = source.read<glm::vec3>("COLOR_0", vertices.count, vertices.selection);
  std::vector<glm::vec4> colours;
  for (const glm::vec3& colour : opaque) colours.emplace_back(colour, 1.0f);
  return colours;
}

constexpr std::size_t kMaxSets = 16;  // 64 joints per vertex. Other readers support 4 or 8.

std::string jointsOf(std::size_t set) { return fmt::format("JOINTS_{}", set); }
std::string weightsOf(std::size_t set) { return fmt::format("WEIGHTS_{}", set); }

// The sets are numbered from 0 without gaps.
std::size_t countSets(const VertexSource& source) {
  std::size_t count = 0;
  while (source.attribute(jointsOf(count)) && source.attribute(weightsOf(count))) {
    if (count == kMaxSets) {
      source.attribute(jointsOf(count))->fail(fmt::format("at most {} sets of joints are read", kMaxSets));
    }
    ++count;
  }
  return count;
}

}  // namespace

Influences readInfluences(const VertexSource& source, const Vertices& vertices) {
  Influences influences;
  for (std::size_t set = 0; set < countSets(source); ++set) {
    influences.joints.push_back(source.readWhole(jointsOf(set), vertices.count, vertices.selection));
    influences.weights.push_back(source.read<glm::vec4>(weightsOf(set), vertices.count, vertices.selection));
  }
  return influences;
}

// Memory of all vertices and indices, used or not, in bytes.
std::uint64_t bytesOf(const VertexSource& source, bool isSkinned) {
  std::size_t perVertex = sizeof(glm::vec3);
  if (source.attribute("NORMAL")) perVertex += sizeof(glm::vec3);
  if (source.attribute("TANGENT")) perVertex += sizeof(glm::vec4);
  if (source.attribute("COLOR_0")) perVertex += sizeof(glm::vec4);
  for (const char* const name : {"TEXCOORD_0", "TEXCOORD_1"}) {
    if (source.attribute(name)) perVertex += sizeof(glm::vec2);
  }
  if (isSkinned) perVertex += countSets(source) * (sizeof(glm::uvec4) + sizeof(glm::vec4));
  const std::uint64_t vertices = source.vertexCount();
  return vertices * perVertex + source.indexCount(vertices) * sizeof(std::uint32_t);
}

/// Without normals, tangents are ignored: section 3.7.2.1 of the specification. Of both, 0 is permitted: place() then
/// takes the triangle's normal, and there is no normal map at the vertex.
void readAttributes(const VertexSource& source, const Vertices& vertices, scene::Mesh& mesh) {
  const auto& [count, selection] = vertices;
  mesh.positions = source.read<glm::vec3>("POSITION", count, selection);
  if (source.attribute("NORMAL")) mesh.normals = source.read<glm::vec3>("NORMAL", count, selection, NonFinite::zero);
  if (!mesh.normals.empty() && source.attribute("TANGENT")) {
    mesh.tangents = source.read<glm::vec4>("TANGENT", count, selection, NonFinite::zero);
  }
  for (std::size_t set = 0; set < mesh.texCoords.size(); ++set) {
    const std::string name = fmt::format("TEXCOORD_{}", set);
    if (source.attribute(name)) mesh.texCoords[set] = source.read<glm::vec2>(name, count, selection);
  }
  mesh.colours = readColours(source, vertices);
}

}  // namespace candela::gltf

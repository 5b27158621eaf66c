// Reads primitives and their morph targets.
#include "host/formats/gltf/geometry.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/base/memory_budget.h"
#include "host/formats/gltf/vertex_source.h"

namespace candela::gltf {
namespace {

/// The vertices of a primitive: all that its attributes have, and those that it uses.
struct Vertices {
  std::size_t count = 0;
  Selection selection{};
};

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

/// Returns the joints of the vertices and their weights. Throws JsonError.
Influences readInfluences(const VertexSource& source, const Vertices& vertices) {
  Influences influences;
  for (std::size_t set = 0; set < countSets(source); ++set) {
    influences.joints.push_back(source.readWhole(jointsOf(set), vertices.count, vertices.selection));
    influences.weights.push_back(source.read<glm::vec4>(weightsOf(set), vertices.count, vertices.selection));
  }
  return influences;
}

// Memory of all vertices and indices, used or not, in bytes.
/// Returns the memory of all vertices and indices, used or not, in bytes.
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
/// Sets the positions, normals, tangents, texture coordinates and colours of a mesh, the colours as stored. Throws
/// JsonError.
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

/// Adds `weight` times a target's displacements, which are of the type `Move`, to the first components of an attribute.
template <class Move, class Vector>
void addTarget(const Value& target, const std::string& name, float weight, const Vertices& vertices,
               Accessors& accessors, std::vector<Vector>& values) {
  const std::optional<Value> reference = target.find(name);
  if (!reference || values.empty()) return;
  requireCount(*reference, accessors.type(*reference).count, vertices.count);
  const std::vector<Move> moves = accessors.read<Move>(*reference, vertices.selection);
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (glm::length_t c = 0; c < Move::length(); ++c) values[i][c] += weight * moves[i][c];
  }
}

void addColours(const Value& target, float weight, const Vertices& vertices, Accessors& accessors,
                std::vector<glm::vec4>& colours) {
  const std::optional<Value> reference = target.find("COLOR_0");
  if (!reference) return;
  if (accessors.type(*reference).components == 4) {
    addTarget<glm::vec4>(target, "COLOR_0", weight, vertices, accessors, colours);
  } else {
    addTarget<glm::vec3>(target, "COLOR_0", weight, vertices, accessors, colours);
  }
}

void addTargets(const Value& primitive, std::span<const double> weights, const Vertices& vertices, Accessors& accessors,
                scene::Mesh& mesh) {
  const std::optional<Value> targets = primitive.find("targets");
  if (!targets) return;
  for (std::size_t i = 0; i < targets->size() && i < weights.size(); ++i) {
    const auto weight = static_cast<float>(weights[i]);
    if (weight == 0) continue;
    const Value target = (*targets)[i];
    addTarget<glm::vec3>(target, "POSITION", weight, vertices, accessors, mesh.positions);
    addTarget<glm::vec3>(target, "NORMAL", weight, vertices, accessors, mesh.normals);
    addTarget<glm::vec3>(target, "TANGENT", weight, vertices, accessors, mesh.tangents);
    for (std::size_t set = 0; set < mesh.texCoords.size(); ++set) {
      const std::string name = fmt::format("TEXCOORD_{}", set);
      addTarget<glm::vec2>(target, name, weight, vertices, accessors, mesh.texCoords[set]);
    }
    addColours(target, weight, vertices, accessors, mesh.colours);
  }
}

/// Lists what targets move although the primitive lacks it, against section 3.7.2.2 of the specification: attributes
/// that are rendered otherwise, of targets whose weight is not 0.
std::vector<std::string> surplusTargets(const Value& primitive, const VertexSource& source,
                                        std::span<const double> weights) {
  std::vector<std::string> surplus;
  const std::optional<Value> targets = primitive.find("targets");
  for (std::size_t i = 0; targets && i < targets->size() && i < weights.size(); ++i) {
    if (weights[i] == 0) continue;
    for (const char* name : {"NORMAL", "TANGENT", "TEXCOORD_0", "TEXCOORD_1", "COLOR_0"}) {
      const std::optional<Value> reference = (*targets)[i].find(name);
      if (reference && !source.attribute(name)) surplus.push_back(reference->pointer());
    }
  }
  return surplus;
}

/// Colours are clamped to [0, 1] after morph targets have moved them: sections 3.7.2.1 and 3.7.2.2 of the
/// specification.
void clampColours(std::vector<glm::vec4>& colours) {
  for (glm::vec4& colour : colours) colour = glm::clamp(colour, 0.0f, 1.0f);
}

/// Numbers the vertices that are used anew, in their order, and returns their old indices.
std::vector<std::uint32_t> compactIndices(std::vector<std::uint32_t>& indices) {
  std::vector<std::uint32_t> used = indices;
  std::ranges::sort(used);
  used.erase(std::unique(used.begin(), used.end()), used.end());
  for (std::uint32_t& index : indices) {
    index = static_cast<std::uint32_t>(std::ranges::lower_bound(used, index) - used.begin());
  }
  return used;
}

/// Selects the vertices of triangles, if there are more than twice as many vertices as corners. Draco decodes no data
/// with more vertices than corners.
Selection selectVertices(const VertexSource& source, std::size_t count, std::vector<std::uint32_t>& indices) {
  if (source.isCompressed() || count <= 2 * indices.size()) return std::nullopt;
  return compactIndices(indices);
}

}  // namespace

Topology topologyOf(const Value& primitive) {
  const std::uint64_t mode = primitive.wholeOr("mode", 4);
  if (mode > 6) primitive.require("mode").fail(fmt::format("{} is not a mode (0 to 6)", mode));
  if (mode < 4) return Topology::pointsOrLines;
  if (mode == 4) return Topology::triangles;
  return mode == 5 ? Topology::strip : Topology::fan;
}

std::vector<std::uint32_t> toTriangles(Topology topology, std::vector<std::uint32_t> indices) {
  if (topology == Topology::triangles) {
    indices.resize(indices.size() / 3 * 3);
    return indices;
  }
  std::vector<std::uint32_t> triangles;
  for (std::size_t i = 0; i + 2 < indices.size(); ++i) {
    if (topology == Topology::strip) {
      triangles.insert(triangles.end(), {indices[i], indices[i + 1 + i % 2], indices[i + 2 - i % 2]});
    } else {
      triangles.insert(triangles.end(), {indices[i + 1], indices[i + 2], indices[0]});
    }
  }
  return triangles;
}

std::optional<Geometry> readGeometry(const Value& primitive, const GeometryUse& use, Accessors& accessors,
                                     Buffers& buffers) {
  const VertexSource source(primitive, accessors, buffers);
  if (!source.attribute("POSITION")) return std::nullopt;
  requireMemory(fmt::format("{}: with this primitive, the scene", primitive.pointer()),
                use.usedBytes + bytesOf(source, use.isSkinned), "use a machine with more memory");
  Geometry geometry;
  scene::Mesh& mesh = geometry.mesh;
  Vertices vertices{source.vertexCount()};
  mesh.indices = toTriangles(topologyOf(primitive), source.readIndices(vertices.count));
  vertices.selection = selectVertices(source, vertices.count, mesh.indices);
  readAttributes(source, vertices, mesh);
  if (use.isSkinned) geometry.influences = readInfluences(source, vertices);
  addTargets(primitive, use.morphWeights, vertices, accessors, mesh);
  clampColours(mesh.colours);
  geometry.surplusTargets = surplusTargets(primitive, source, use.morphWeights);
  return geometry;
}

}  // namespace candela::gltf

// Reads primitives and their morph targets.
#include "host/formats/gltf/geometry.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/base/memory_budget.h"
#include "host/formats/gltf/vertex_attributes.h"

namespace candela::gltf {
namespace {

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

// The triangles of a primitive, in the coordinates of its mesh.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/formats/gltf/vertex_source.h"
#include "host/scene/mesh.h"

namespace candela::gltf {

/// The joints that move a vertex, and their weights: four for each set JOINTS_n and WEIGHTS_n.
struct Influences {
  std::vector<std::vector<glm::uvec4>> joints;  ///< by set, then by vertex
  std::vector<std::vector<glm::vec4>> weights;  ///< sums are as the file has them
};

struct Geometry {
  scene::Mesh mesh;  ///< its normals may have any length, 0 included
  Influences influences;
  /// JSON pointers of attributes of morph targets that are left out, since the primitive lacks the attribute.
  std::vector<std::string> surplusTargets;
};

/// glTF's `mode`: triangles 4, strips 5, fans 6; 0 to 3 are points and lines.
enum class Topology : std::uint8_t { pointsOrLines, triangles, strip, fan };
Topology topologyOf(const Value& primitive);

/// How a primitive is read.
struct GeometryUse {
  std::span<const double> morphWeights;  ///< by target; missing weights are 0
  bool isSkinned = false;                ///< without a skin, influences are not read
  std::uint64_t usedBytes = 0;           ///< memory that the scene takes so far
};

/// Reads a primitive of triangles with its morph targets. Of uncompressed vertices, only those that triangles use are
/// read, if there are more than twice as many vertices as corners: primitives may share one large set of vertices.
/// Nothing if it has no positions. Throws JsonError, and OutOfMemoryError before anything is read if the result would
/// exceed the memory budget.
std::optional<Geometry> readGeometry(const Value& primitive, const GeometryUse& use, Accessors& accessors,
                                     Buffers& buffers);

/// Three vertices for each triangle of a strip or fan, in the order of the specification (section 3.7.2.1). A rest of
/// fewer than three vertices is left out.
std::vector<std::uint32_t> toTriangles(Topology topology, std::vector<std::uint32_t> indices);

}  // namespace candela::gltf

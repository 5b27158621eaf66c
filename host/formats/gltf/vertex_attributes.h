// The attributes of the vertices of a primitive.
#pragma once
#include "host/formats/gltf/geometry.h"
#include "host/formats/gltf/vertex_source.h"

namespace candela::gltf {

/// The vertices of a primitive: all that its attributes have, and those that it uses.
struct Vertices {
  std::size_t count = 0;
  Selection selection{};
};

/// Returns the memory of all vertices and indices, used or not, in bytes.
std::uint64_t bytesOf(const VertexSource& source, bool isSkinned);

/// Sets the positions, normals, tangents, texture coordinates and colours of a mesh, the colours as stored. Throws
/// JsonError.
void readAttributes(const VertexSource& source, const Vertices& vertices, scene::Mesh& mesh);

/// Returns the joints of the vertices and their weights. Throws JsonError.
Influences readInfluences(const VertexSource& source, const Vertices& vertices);

}  // namespace candela::gltf

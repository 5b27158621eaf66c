// KHR_draco_mesh_compression: the triangles and vertices of a primitive, compressed by Draco.
#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "host/formats/gltf/value.h"

namespace candela::gltf {

/// A decoded primitive.
struct DracoMesh {
  struct Attribute {
    std::size_t components = 0;
    /// Whether the values are integers. They are as they are stored: the glTF accessor says whether they are
    /// normalised, not the flag in Draco's data, which encoders set or leave as they like.
    bool isIntegral = false;
    std::vector<float> values;  ///< all components of each vertex
  };
  std::size_t vertexCount = 0;
  std::vector<std::uint32_t> indices;           ///< three for each triangle, below vertexCount
  std::map<std::string, Attribute> attributes;  ///< by glTF's names: "POSITION"
};

/// Returns whether this program was built with Draco.
bool canDecodeDraco();

/// `extension` is the extension's object, `source` the bytes of its buffer view. Throws JsonError for damaged data and
/// for attributes that are not in it.
DracoMesh decodeDraco(const Value& extension, std::span<const std::byte> source);

}  // namespace candela::gltf

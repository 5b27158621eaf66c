// Decodes meshes by Draco.
#include "host/formats/gltf/draco.h"

#include <draco/compression/decode.h>

#include <cmath>

namespace candela::gltf {
namespace {

/// Draco's fractions and stored integers as floats; the vertices of corners that share all attributes are one.
DracoMesh::Attribute readAttribute(const draco::Mesh& mesh, const Value& id) {
  const draco::PointAttribute* const source = mesh.GetAttributeByUniqueId(static_cast<std::uint32_t>(id.whole()));
  if (source == nullptr) id.fail("the compressed data has no such attribute");
  const auto components = static_cast<std::size_t>(source->num_components());
  if (components < 1 || components > 4) id.fail("the compressed attribute does not have 1 to 4 components");
  DracoMesh::Attribute attribute{components, draco::IsDataTypeIntegral(source->data_type()),
                                 std::vector<float>(components * mesh.num_points())};
  for (draco::PointIndex point(0); point < mesh.num_points(); ++point) {
    float* const values = attribute.values.data() + components * point.value();
    if (!source->ConvertValue<float>(source->mapped_index(point), static_cast<std::int8_t>(components), values)) {
      id.fail("the compressed attribute cannot be converted");
    }
    for (std::size_t c = 0; c < components; ++c) {
      if (!std::isfinite(values[c])) id.fail("a value of the compressed attribute is not finite");
    }
  }
  return attribute;
}

/// Has ConvertValue() return integers as they are stored.
void ignoreNormalisation(draco::Mesh& mesh) {
  for (int i = 0; i < mesh.num_attributes(); ++i) mesh.attribute(i)->set_normalized(false);
}

std::vector<std::uint32_t> readIndices(const draco::Mesh& mesh, const Value& extension) {
  std::vector<std::uint32_t> indices;
  indices.reserve(3 * std::size_t{mesh.num_faces()});
  for (draco::FaceIndex face(0); face < mesh.num_faces(); ++face) {
    for (const draco::PointIndex& point : mesh.face(face)) {
      if (point.value() >= mesh.num_points()) extension.fail("an index of the compressed data is out of range");
      indices.push_back(point.value());
    }
  }
  return indices;
}

}  // namespace

bool canDecodeDraco() { return true; }

DracoMesh decodeDraco(const Value& extension, std::span<const std::byte> source) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(source.data()), source.size());
  draco::Decoder decoder;
  const draco::StatusOr<std::unique_ptr<draco::Mesh>> decoded = decoder.DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok()) extension.fail("the compressed data is damaged");
  draco::Mesh& compressed = *decoded.value();
  ignoreNormalisation(compressed);
  DracoMesh mesh{compressed.num_points(), readIndices(compressed, extension), {}};
  const Value attributes = extension.require("attributes");
  if (!attributes.json().is_object()) attributes.fail("expected an object");
  for (const auto& [name, id] : attributes.json().items()) {
    mesh.attributes.emplace(name, readAttribute(compressed, attributes.require(name)));
  }
  return mesh;
}

}  // namespace candela::gltf

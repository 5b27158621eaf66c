// Reads the vertices of a primitive.
#include "host/formats/gltf/vertex_source.h"

#include <fmt/format.h>

#include <numeric>

namespace candela::gltf {

void requireCount(const Value& reference, std::size_t count, std::size_t expected) {
  if (count != expected) reference.fail(fmt::format("{} values for {} vertices", count, expected));
}

VertexSource::VertexSource(const Value& primitive, Accessors& accessors, Buffers& buffers)
    : primitive_(primitive), attributes_(primitive.require("attributes")), accessors_(accessors) {
  const std::optional<Value> draco = extensionOf(primitive, "KHR_draco_mesh_compression");
  if (draco && canDecodeDraco()) draco_ = decodeDraco(*draco, buffers.view(draco->require("bufferView")).bytes);
}

const DracoMesh::Attribute* VertexSource::compressed(const std::string& name, std::size_t components) const {
  if (!draco_) return nullptr;
  const auto found = draco_->attributes.find(name);
  if (found == draco_->attributes.end()) return nullptr;
  if (found->second.components != components) {
    attributes_.require(name).fail(
        fmt::format("the compressed values have {} components instead of {}", found->second.components, components));
  }
  return &found->second;
}

std::size_t VertexSource::components(const Value& reference, const std::string& name) const {
  if (draco_ && draco_->attributes.contains(name)) return draco_->attributes.at(name).components;
  return accessors_.type(reference).components;
}

std::size_t VertexSource::vertexCount() const {
  return draco_ ? draco_->vertexCount : accessors_.count(attributes_.require("POSITION"));
}

std::size_t VertexSource::indexCount(std::size_t vertexCount) const {
  if (draco_) return draco_->indices.size();
  const std::optional<Value> reference = primitive_.find("indices");
  return reference ? accessors_.count(*reference) : vertexCount;
}

std::vector<glm::uvec4> VertexSource::readWhole(const std::string& name, std::size_t count,
                                                const Selection& selection) const {
  const Value reference = attributes_.require(name);
  std::vector<glm::uvec4> values;
  if (const DracoMesh::Attribute* source = compressed(name, 4)) {
    for (std::size_t i = 0; i < source->values.size(); i += 4) {
      glm::vec4 value;
      for (glm::length_t c = 0; c < 4; ++c) value[c] = source->values[i + static_cast<std::size_t>(c)];
      if (glm::any(glm::lessThan(value, glm::vec4(0))) || glm::any(glm::greaterThan(value, glm::vec4(65535)))) {
        reference.fail("the compressed values are not 16-bit unsigned integers");
      }
      values.emplace_back(value);
    }
    requireCount(reference, values.size(), count);
  } else {
    requireCount(reference, accessors_.type(reference).count, count);
    const std::vector<std::uint32_t> words = accessors_.readWhole(reference, 4, selection);
    for (std::size_t i = 0; i < words.size(); i += 4) {
      values.emplace_back(words[i], words[i + 1], words[i + 2], words[i + 3]);
    }
  }
  return values;
}

std::vector<std::uint32_t> VertexSource::readIndices(std::size_t vertexCount) const {
  if (draco_) return draco_->indices;
  const std::optional<Value> reference = primitive_.find("indices");
  std::vector<std::uint32_t> indices;
  if (!reference) {
    indices.resize(vertexCount);
    std::iota(indices.begin(), indices.end(), 0u);
    return indices;
  }
  indices = accessors_.readWhole(*reference, 1);
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (indices[i] >= vertexCount) {
      reference->fail(fmt::format("element {} is {}, but there are {} vertices", i, indices[i], vertexCount));
    }
  }
  return indices;
}

}  // namespace candela::gltf

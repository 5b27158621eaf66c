// The source of the vertices of a primitive: accessors, or data compressed by Draco.
#pragma once
#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/formats/gltf/accessor.h"
#include "host/formats/gltf/draco.h"

namespace candela::gltf {

/// The attributes and indices of one element of `primitives`. Functions throw JsonError.
class VertexSource {
 public:
  /// `accessors` must outlive this object.
  VertexSource(const Value& primitive, Accessors& accessors, Buffers& buffers);

  /// The reference to the accessor of an attribute, if the primitive has it.
  std::optional<Value> attribute(const std::string& name) const { return attributes_.find(name); }
  /// Returns the number of components of the attribute to which `reference` refers.
  std::size_t components(const Value& reference, const std::string& name) const;

  /// Number of values of the attribute POSITION, which must exist.
  std::size_t vertexCount() const;
  /// Number of indices that readIndices() returns for this number of vertices.
  std::size_t indexCount(std::size_t vertexCount) const;
  /// The values of an attribute that exists, of the selected vertices. The attribute must have `count` of them in all.
  template <class Vector>
  std::vector<Vector> read(const std::string& name, std::size_t count, const Selection& selection,
                           NonFinite nonFinite = NonFinite::refused) const;
  /// The four unsigned integers of each selected vertex in an attribute that exists.
  std::vector<glm::uvec4> readWhole(const std::string& name, std::size_t count, const Selection& selection) const;
  /// Indices of vertices, each below `vertexCount`; 0, 1, 2 ... if the primitive has none.
  std::vector<std::uint32_t> readIndices(std::size_t vertexCount) const;
  /// Returns whether vertices are compressed, so that all of them must be read.
  bool isCompressed() const { return draco_.has_value(); }

 private:
  const DracoMesh::Attribute* compressed(const std::string& name, std::size_t components) const;

  Value primitive_;
  Value attributes_;
  Accessors& accessors_;
  std::optional<DracoMesh> draco_;
};

/// Throws JsonError at the reference unless the numbers are equal.
void requireCount(const Value& reference, std::size_t count, std::size_t expected);

template <class Vector>
std::vector<Vector> VertexSource::read(const std::string& name, std::size_t count, const Selection& selection,
                                       NonFinite nonFinite) const {
  const Value reference = attributes_.require(name);
  constexpr std::size_t kComponents = sizeof(Vector) / sizeof(float);
  if (const DracoMesh::Attribute* source = compressed(name, kComponents)) {
    std::vector<Vector> values(draco_->vertexCount);
    const std::span numbers(reinterpret_cast<float*>(values.data()), values.size() * kComponents);
    std::ranges::copy(source->values, numbers.begin());
    if (source->isIntegral) normalise(accessors_.type(reference), numbers);
    return values;
  }
  requireCount(reference, accessors_.type(reference).count, count);
  return accessors_.read<Vector>(reference, selection, nonFinite);
}

}  // namespace candela::gltf

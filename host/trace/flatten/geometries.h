// The geometries of a scene: where the attributes of triangles' vertices are, and which lights they are.
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

#include "host/scene/scene.h"
#include "host/trace/flatten/flat_rows.h"
#include "host/trace/flatten/flat_scene.h"

namespace candela::flatten {

/// Returns whether textures of the material of a triangle read set 1 of its mesh's texture coordinates.
bool hasSecondTexCoords(const scene::Scene& scene, const scene::Primitive& triangle);

/// Returns whether attributes are stored for each vertex of a mesh. Otherwise it has no indices, or its triangles share
/// so few vertices that attributes are stored for each of their corners.
bool isIndexed(const scene::Mesh& mesh);

/// Returns whether numbers of vertices of an indexed mesh need more than kCornerBits bits.
inline bool needsLongCorners(const scene::Mesh& mesh) {
  return mesh.positions.size() > gpu::kMaxPackedVertices && isIndexed(mesh);
}

/// Collects the geometries of triangles. Arrays of attributes and equal geometries are stored once.
class Geometries {
 public:
  /// `keepsTexCoords`: even where no texture needs the texture coordinates. `hasLongCorners`: the feature longCorners.
  /// The scene must outlive the object.
  Geometries(const scene::Scene& scene, bool keepsTexCoords, bool hasLongCorners)
      : scene_(&scene), keepsTexCoords_(keepsTexCoords), hasLongCorners_(hasLongCorners) {}

  /// Returns the geometry of the triangles of a run that are not in the light table; 0 if they have no attributes.
  std::uint32_t ofRun(const scene::PrimitiveRun& run) { return numberOf(run.start, run.first); }
  /// Returns that of the triangles of a prototype, by one of the runs that show it.
  std::uint32_t ofPrototype(const scene::PrimitiveRun& run);
  /// Returns that of a primitive of a run for which ofRun() returned `geometry`, if it is in the light table: `light`
  /// is its index in the table + 1.
  std::uint32_t ofLight(std::uint32_t geometry, std::uint32_t primitive, std::uint32_t light);

  /// Returns that of the triangles of a run for which ofRun() returned `geometry`, if it is an instance that emits:
  /// `first` is the index of its first primitive.
  std::uint32_t ofLightInstance(std::uint32_t geometry, std::uint32_t first, std::uint32_t light);

  /// Returns the number of records that append() appends.
  std::size_t countRows() const { return gpu::kGeometryRows * records_.size() + arrayRows_; }
  /// Appends the records of all geometries, followed by their attributes, and sets the constants that refer to them.
  void append(FlatScene& flat) const;

 private:
  using Record = std::array<std::uint32_t, 4 * gpu::kGeometryRows>;
  enum class Kind : std::uint8_t { corners, normals, texCoords, bothTexCoords, colours, tangents };
  using ArrayKey = std::tuple<std::uint32_t, Kind, std::uint32_t>;  ///< mesh, kind, placement

  std::uint32_t numberOf(const scene::Primitive& start, std::uint32_t firstIndex);
  std::uint32_t numberOf(const Record& record);
  std::uint32_t arrayOf(const scene::Primitive& start, Kind kind);
  std::size_t rowsOf(const scene::Mesh& mesh, Kind kind) const;
  /// Returns the index of the corners of the first triangle in an array of corners.
  std::uint32_t firstCorners(std::uint32_t firstRow) const;
  void fillCorners(const scene::Mesh& mesh, gpu::uvec4* rows, std::uint32_t firstRow) const;
  std::uint32_t attributeFlags(const scene::Primitive& triangle) const;
  void fill(const ArrayKey& key, gpu::uvec4* rows, std::uint32_t firstRow) const;

  const scene::Scene* scene_;
  bool keepsTexCoords_;
  bool hasLongCorners_;
  std::vector<Record> records_{Record{}};
  std::map<Record, std::uint32_t> numbers_{{Record{}, 0}};
  std::map<ArrayKey, std::uint32_t> arrays_;  ///< first record, counted from the beginning of the attributes
  std::size_t arrayRows_ = 0;
};

}  // namespace candela::flatten

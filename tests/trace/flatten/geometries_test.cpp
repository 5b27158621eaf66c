// Geometries: what the device reads of the vertices of triangles is what the scene says, and what they take.
#include "host/trace/flatten/geometries.h"

#include <array>
#include <bit>
#include <catch2/catch.hpp>

#include "host/formats/loading/scene_builder.h"
#include "host/trace/flatten/light_table.h"
#include "shaders/shared/scene_rows.h"
#include "tests/trace/light/normal_mapped_meshes.h"
#include "tests/trace/reference/default_settings.h"
#include "tests/trace/reference/scene_builder.h"

using namespace candela;
using glm::vec3;
using glm::vec4;
using test::SceneBuilder;

namespace {

// A triangle as the device reads it, by the description in scene_rows.h.
class Reader {
 public:
  Reader(const flatten::FlatScene& flat, std::uint32_t slot) : flat_(&flat) {
    const std::size_t row = flat.constants.firstPrimitiveRow + std::size_t{slot} * gpu::kPrimitiveRows;
    geometry_ = flat.rows[row].w;
    index_ = flat.rows[row + 1].w;
    const std::size_t first = flat.constants.firstGeometryRow + std::size_t{geometry_} * gpu::kGeometryRows;
    first_ = flat.rows[first];
    second_ = flat.rows[first + 1];
  }

  std::uint32_t geometry() const { return geometry_; }
  std::uint32_t index() const { return index_; }
  bool has(std::uint32_t flag) const { return (first_.x & flag) != 0; }
  std::uint32_t normals() const { return first_.z; }
  std::uint32_t texCoords() const { return first_.w; }
  std::uint32_t light() const { return second_.x != 0 ? second_.y + index_ : 0; }

  vec3 normal(std::uint32_t corner) const { return vec3(element(first_.z, corner)); }
  vec4 colour(std::uint32_t corner) const { return element(second_.z, corner); }
  vec4 tangent(std::uint32_t corner) const { return element(second_.w, corner); }
  glm::vec2 texCoord(std::uint32_t corner, int set) const {
    if (has(gpu::kGeometrySecondTexCoords)) {
      const vec4 both = element(first_.w, corner);
      return set == 0 ? glm::vec2(both.x, both.y) : glm::vec2(both.z, both.w);
    }
    const std::uint32_t word = 2 * vertex(corner);
    return {std::bit_cast<float>(wordOf(first_.w, word)), std::bit_cast<float>(wordOf(first_.w, word + 1))};
  }

 private:
  std::uint32_t vertex(std::uint32_t corner) const {
    if (!has(gpu::kGeometryIndexed)) return first_.y + 3 * index_ + corner;
    const std::uint32_t corners = first_.y + index_;
    if (flat_->shape.features.longCorners) return wordOf(0, 3 * corners + corner);
    const std::uint64_t bits = wordOf(0, 2 * corners) | std::uint64_t{wordOf(0, 2 * corners + 1)} << 32;
    return static_cast<std::uint32_t>(bits >> (gpu::kCornerBits * corner)) & (gpu::kMaxPackedVertices - 1);
  }
  std::uint32_t wordOf(std::uint32_t firstRow, std::uint32_t i) const {
    return flat_->rows[flat_->constants.firstAttributeRow + firstRow + i / 4][static_cast<glm::length_t>(i % 4)];
  }
  vec4 element(std::uint32_t firstRow, std::uint32_t corner) const {
    const gpu::uvec4& row = flat_->rows[flat_->constants.firstAttributeRow + firstRow + vertex(corner)];
    return {std::bit_cast<float>(row.x), std::bit_cast<float>(row.y), std::bit_cast<float>(row.z),
            std::bit_cast<float>(row.w)};
  }

  const flatten::FlatScene* flat_;
  std::uint32_t geometry_ = 0;
  std::uint32_t index_ = 0;
  gpu::uvec4 first_{0};
  gpu::uvec4 second_{0};
};

flatten::FlatScene flattened(const scene::Scene& scene, bool copiesInstances = false) {
  render::RenderSettings settings = test::settingsOf(8, 8, 1);
  settings.structure.copiesInstances = copiesInstances;
  return flatten::flattenScene(scene, settings);
}

scene::Material diffuse(double weight) {
  scene::Material material;
  material.diffuse.emplace().weight = weight;
  return material;
}

scene::Material texturedMaterial(std::uint8_t set) {
  scene::Material material = diffuse(1);
  material.textures[static_cast<std::size_t>(scene::TextureSlot::baseColour)].emplace().texCoordSet = set;
  return material;
}

SceneBuilder withImage() {
  SceneBuilder b;
  b.scene.images.push_back(test::oneTexel(255, 128, 0));
  return b;
}

// A closed mesh with every attribute, all of whose values differ.
scene::Mesh fullMesh(float shift) {
  scene::Mesh mesh = test::ball({shift, 0, 0}, 1, 3);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const auto x = static_cast<float>(i);
    mesh.texCoords[1].emplace_back(x + 0.25f, x + 0.5f);
    mesh.colours.emplace_back(x, x + 0.125f, x + 0.375f, x + 0.625f);
  }
  return mesh;
}

// Compares every triangle of the scene's own slots with the scene.
void checkTriangles(const scene::Scene& scene, const flatten::FlatScene& flat) {
  std::size_t mismatches = 0;
  for (std::uint32_t slot = 0; slot < flat.shape.slotCount; ++slot) {
    const Reader reader(flat, slot);
    const scene::Primitive triangle = scene.primitives[reader.index()];
    if (triangle.kind != scene::PrimitiveKind::triangle) continue;
    const scene::Mesh& mesh = meshOf(scene, triangle);
    for (std::uint32_t corner = 0; corner < 3; ++corner) {
      const std::size_t vertex = vertexIndex(mesh, triangle.index, corner);
      const auto equals = [&](std::uint32_t flag, const auto& isEqual) {
        if (reader.has(flag) && !isEqual()) ++mismatches;
      };
      equals(gpu::kGeometryNormals,
             [&] { return reader.normal(corner) == vertexNormalsOf(scene, triangle).n[corner]; });
      equals(gpu::kGeometryTexCoords, [&] {
        return reader.texCoord(corner, 0) == (mesh.texCoords[0].empty() ? glm::vec2(0) : mesh.texCoords[0][vertex]);
      });
      equals(gpu::kGeometrySecondTexCoords, [&] { return reader.texCoord(corner, 1) == mesh.texCoords[1][vertex]; });
      equals(gpu::kGeometryColours, [&] { return reader.colour(corner) == mesh.colours[vertex]; });
      equals(gpu::kGeometryTangents,
             [&] { return reader.tangent(corner) == vertexTangentsOf(scene, triangle)[corner]; });
    }
  }
  CHECK(mismatches == 0);
}

// Returns the number of records of attributes, which follow those of geometries.
std::size_t attributeRows(const flatten::FlatScene& flat) {
  return flat.constants.firstMaterialRow - flat.constants.firstAttributeRow;
}

std::size_t geometryCount(const flatten::FlatScene& flat) {
  return (flat.constants.firstAttributeRow - flat.constants.firstGeometryRow) / gpu::kGeometryRows;
}

// A flat grid of triangles.
scene::Mesh grid(std::uint32_t side) {
  scene::Mesh mesh;
  for (std::uint32_t y = 0; y <= side; ++y) {
    for (std::uint32_t x = 0; x <= side; ++x) {
      mesh.positions.emplace_back(x, y, 0);
      mesh.normals.emplace_back(static_cast<float>(mesh.normals.size()), 0, 0);
      if (x == side || y == side) continue;
      const std::uint32_t at = y * (side + 1) + x;
      mesh.indices.insert(mesh.indices.end(), {at, at + 1, at + side + 2, at, at + side + 2, at + side + 1});
    }
  }
  return mesh;
}

}  // namespace

TEST_CASE("geometries: every corner has the attributes of its vertex") {
  SceneBuilder b = withImage();
  b.material(diffuse(1));
  addMesh(b.scene, fullMesh(0), 0);
  b.material(texturedMaterial(0));
  addMesh(b.scene, fullMesh(3), 1);
  b.material(texturedMaterial(1));
  addMesh(b.scene, fullMesh(6), 2);
  b.material(test::mapped({}));
  addMesh(b.scene, fullMesh(9), 3);
  scene::Mesh unindexed = fullMesh(12);
  unindexed.indices.clear();
  for (auto* vectors : std::array{&unindexed.positions, &unindexed.normals}) vectors->resize(90);
  for (auto& set : unindexed.texCoords) set.resize(90);
  for (auto* vectors : std::array{&unindexed.colours, &unindexed.tangents}) vectors->resize(90);
  addMesh(b.scene, unindexed, 2);
  const flatten::FlatScene flat = flattened(b.scene);
  checkTriangles(b.scene, flat);
  CHECK(flat.shape.features.secondTexCoords);
  constexpr std::uint32_t kAlways = gpu::kGeometryNormals | gpu::kGeometryColours;
  constexpr std::array kFlags{kAlways, kAlways | gpu::kGeometryTexCoords,
                              kAlways | gpu::kGeometryTexCoords | gpu::kGeometrySecondTexCoords,
                              kAlways | gpu::kGeometryTexCoords | gpu::kGeometryTangents};
  std::size_t mismatches = 0;
  for (std::uint32_t slot = 0; slot < flat.shape.slotCount; ++slot) {
    const Reader reader(flat, slot);
    const scene::Primitive triangle = b.scene.primitives[reader.index()];
    for (std::uint32_t flag = 1; flag < gpu::kGeometryIndexed; flag *= 2) {
      if (reader.has(flag) != ((kFlags[triangle.material] & flag) != 0)) ++mismatches;
    }
    if (reader.has(gpu::kGeometryIndexed) != (triangle.mesh < 4)) ++mismatches;
  }
  CHECK(mismatches == 0);
}

TEST_CASE("geometries: attributes of a closed mesh are stored once for each vertex") {
  SceneBuilder b = withImage();
  b.material(texturedMaterial(0));
  scene::Mesh mesh = test::ball({0, 0, 0}, 1, 3);
  addMesh(b.scene, mesh, 0);
  const std::size_t triangles = mesh.indices.size() / 3, vertices = mesh.positions.size();
  const flatten::FlatScene flat = flattened(b.scene);
  CHECK(attributeRows(flat) == (triangles + 1) / 2 + vertices + (vertices + 1) / 2);
  CHECK(geometryCount(flat) == 2);
}

TEST_CASE("geometries: the triangles of a mesh that hardly share vertices have three each") {
  SceneBuilder b;
  b.material(diffuse(1));
  scene::Mesh mesh = test::ball({0, 0, 0}, 1, 3);
  mesh.indices.resize(60);  // 20 triangles among 91 vertices
  addMesh(b.scene, mesh, 0);
  const flatten::FlatScene flat = flattened(b.scene);
  checkTriangles(b.scene, flat);
  CHECK_FALSE(Reader(flat, 0).has(gpu::kGeometryIndexed));
  CHECK(attributeRows(flat) == 60);
}

TEST_CASE("geometries: numbers of vertices may need more than 21 bits") {
  SceneBuilder b;
  b.material(diffuse(1));
  scene::Mesh small = test::ball({0, 0, 9}, 1, 3);
  small.indices.resize(small.indices.size() - 3);  // the next mesh begins within a record
  addMesh(b.scene, small, 0);
  addMesh(b.scene, grid(100), 0);
  const flatten::FlatScene packed = flattened(b.scene);
  CHECK_FALSE(packed.shape.features.longCorners);
  checkTriangles(b.scene, packed);
  addMesh(b.scene, grid(1450), 0);
  const flatten::FlatScene flat = flattened(b.scene);
  CHECK(flat.shape.features.longCorners);
  checkTriangles(b.scene, flat);
}

TEST_CASE("geometries: uses of a mesh share its arrays, and normals of other placements are stored for each") {
  SceneBuilder b = withImage();
  b.material(diffuse(1)).material(diffuse(0.5));
  b.material(texturedMaterial(0));
  const scene::Mesh mesh = test::ball({0, 0, 0}, 1, 3);
  const std::uint32_t stored = storeMesh(b.scene, mesh);
  const auto count = static_cast<std::uint32_t>(mesh.indices.size() / 3);
  for (std::uint32_t i = 0; i < 3; ++i) {
    b.scene.primitives.append({scene::PrimitiveKind::triangle, 0, i, stored}, count);
  }
  addInstance(b.scene, stored, *scene::placementOf(glm::dmat4(2)), 0);
  addInstance(b.scene, stored, *scene::placementOf(glm::dmat4(3)), 2);
  const flatten::FlatScene flat = flattened(b.scene, true);
  checkTriangles(b.scene, flat);
  std::array<std::uint32_t, 5> normals{}, texCoords{};
  for (std::uint32_t slot = 0; slot < flat.shape.slotCount; ++slot) {
    const Reader reader(flat, slot);
    normals[reader.index() / count] = reader.normals();
    texCoords[reader.index() / count] = reader.texCoords();
  }
  CHECK(normals[0] == normals[1]);
  CHECK(normals[0] == normals[2]);
  CHECK(normals[0] != normals[3]);
  CHECK(normals[0] != normals[4]);
  CHECK(normals[3] != normals[4]);
  CHECK(texCoords[2] == texCoords[4]);
  const std::size_t vertices = mesh.positions.size();
  CHECK(attributeRows(flat) == (count + 1) / 2 + 3 * vertices + (vertices + 1) / 2);
}

TEST_CASE("geometries: runs of one mesh whose records are equal are one geometry") {
  SceneBuilder b;
  const scene::VertexNormals up{{{0, 0, 1}, {0, 0, 1}, {0, 1, 0}}};
  for (int i = 0; i < 6; ++i) {
    b.material(diffuse(0.1 * i));
    const auto x = static_cast<float>(i);
    b.patch({x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}, up);
  }
  const flatten::FlatScene flat = flattened(b.scene);
  checkTriangles(b.scene, flat);
  for (std::uint32_t slot = 0; slot < flat.shape.slotCount; ++slot) CHECK(Reader(flat, slot).geometry() == 1);
}

TEST_CASE("geometries: a triangle refers to its light, whatever the attributes of its mesh") {
  SceneBuilder b = withImage();
  scene::Material lamp = texturedMaterial(0);
  lamp.emission = vec3(1);
  b.material(diffuse(1)).quad({-9, -9, -9}, {9, -9, -9}, {9, 9, -9}, {-9, 9, -9});
  b.material(lamp);
  scene::Mesh mesh = test::ball({0, 0, 0}, 1, 3);
  mesh.indices[90] = mesh.indices[91];  // without area: it is not a light, unlike those after it
  addMesh(b.scene, mesh, 1);
  b.material(lamp).quad({-9, -9, 9}, {9, -9, 9}, {9, 9, 9}, {-9, 9, 9});
  const flatten::FlatScene flat = flattened(b.scene);
  checkTriangles(b.scene, flat);
  const std::vector<flatten::LightEntry> table = flatten::buildLightTable(b.scene, true).entries;
  REQUIRE(flat.constants.lightCount == table.size());
  std::vector<std::uint32_t> lightOf(b.scene.primitives.size());
  for (std::uint32_t i = 0; i < table.size(); ++i) lightOf[table[i].index] = i + 1;
  std::size_t lights = 0;
  for (std::uint32_t slot = 0; slot < flat.shape.slotCount; ++slot) {
    const Reader reader(flat, slot);
    CHECK(reader.light() == lightOf[reader.index()]);
    lights += reader.light() != 0;
    if (reader.index() < 2) CHECK(reader.geometry() == 0);
  }
  CHECK(lights == table.size());
  CHECK(geometryCount(flat) < table.size() / 4);  // only triangles without area separate those of the lamp
}

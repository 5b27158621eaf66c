// Meshes that are shown more than once are stored once, and instances place them.
#include <algorithm>
#include <set>

#include "tests/formats/gltf/gltf_file.h"

namespace candela::gltf {
namespace {

// Adds a node that shows the file's mesh.
json& addUse(GltfFile& file, const json& transform) {
  json node{{"mesh", 0}};
  node.update(transform);
  return file.addNode(node);
}

TEST_CASE("nodes that share a mesh store it once, and a mesh that is shown once has no placement") {
  GltfFile file = triangleFile();
  CHECK(sceneOf(file).placements.empty());
  addUse(file, {{"translation", {1, 2, 3}}});
  addUse(file, {{"scale", {2, 3, 4}}});
  const scene::Scene scene = sceneOf(file);
  CHECK(scene.meshes.size() == 1);
  REQUIRE(scene.primitives.size() == 3);
  CHECK(scene.placements.size() == 3);
  CHECK(scene.objectNames.size() == 3);
  CHECK(triangleOf(scene, scene.primitives[1]).p[0] == glm::vec3(1, 2, 3));
  CHECK(triangleOf(scene, scene.primitives[2]).p[1] == glm::vec3(2, 0, 0));
}

TEST_CASE("primitives of different meshes that have the same vertices and other materials share a mesh") {
  GltfFile file = triangleFile();
  file.root["materials"] = {{{"name", "red"}}, {{"name", "green"}}};
  file.primitive()["material"] = 0;
  json other = file.primitive();
  other["material"] = 1;
  file.addMesh(other);
  const scene::Scene scene = sceneOf(file);
  CHECK(scene.meshes.size() == 1);
  REQUIRE(scene.primitives.size() == 2);
  CHECK(scene.primitives[0].material == 0);
  CHECK(scene.primitives[1].material == 1);
}

TEST_CASE("an instance that is mirrored has a mesh whose fronts and tangents are mirrored, too") {
  GltfFile file = triangleFile();
  file.primitive()["attributes"]["NORMAL"] = file.positions({0, 0, 1, 0, 0, 1, 0, 0, 1});
  file.primitive()["attributes"]["TANGENT"] = file.vectors({1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1}, "VEC4", 4);
  addUse(file, {{"scale", {-1, 1, 1}}});
  addUse(file, {{"scale", {1, -1, 1}}});
  const scene::Scene scene = sceneOf(file);
  CHECK(scene.meshes.size() == 2);
  REQUIRE(scene.primitives.size() == 3);
  for (const scene::Primitive& primitive : scene.primitives) {
    const scene::Triangle triangle = triangleOf(scene, primitive);
    CHECK(glm::cross(triangle.p[1] - triangle.p[0], triangle.p[2] - triangle.p[0]).z > 0);
    CHECK(vertexNormalsOf(scene, primitive).n[0].z > 0);
  }
  CHECK(vertexTangentsOf(scene, scene.primitives[0])[0] == glm::vec4(1, 0, 0, 1));
  CHECK(vertexTangentsOf(scene, scene.primitives[1])[0] == glm::vec4(-1, 0, 0, -1));
}

TEST_CASE("uses that are nearly flat, or posed in different ways, are meshes of their own") {
  GltfFile file = triangleFile();
  SECTION("flat") {
    addUse(file, {{"scale", {1, 1, 0}}});
    addUse(file, {{"translation", {0, 0, 1}}});
    const scene::Scene scene = sceneOf(file);
    CHECK(scene.meshes.size() == 2);
    CHECK(scene.placements.size() == 2);
    CHECK(triangleOf(scene, scene.primitives[1]).p[1] == glm::vec3(1, 0, 0));
  }
  SECTION("morphed") {
    file.primitive()["targets"] = {{{"POSITION", file.positions({0, 0, 1, 0, 0, 1, 0, 0, 1})}}};
    addUse(file, {{"weights", {0.5}}});
    addUse(file, {{"weights", {0.5}}});
    const scene::Scene scene = sceneOf(file);
    CHECK(scene.meshes.size() == 2);  // at rest once, and with a weight of 0.5 twice
    CHECK(scene.placements.size() == 2);
    CHECK(triangleOf(scene, scene.primitives[2]).p[0].z == 0.5f);
  }
}

TEST_CASE("an instance beyond the range of single precision is refused at its node") {
  GltfFile file = triangleFile();
  addUse(file, {{"scale", {3e38, 3e38, 3e38}}, {"translation", {3e38, 0, 0}}});
  CHECK(errorsOf(file.text()).find("/nodes/1: a vertex is placed beyond the range of single precision") !=
        std::string::npos);
}

}  // namespace
}  // namespace candela::gltf

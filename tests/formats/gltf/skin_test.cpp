// Skins: joints move vertices by weight, and the node of the mesh does not.
#include "tests/formats/gltf/gltf_file.h"

namespace candela::gltf {
namespace {

/// A triangle with two joints: one at (0 0 5), one that is scaled by 3 about the origin.
GltfFile skinned() {
  GltfFile file = triangleFile();
  file.root["nodes"][0]["skin"] = 0;
  file.root["nodes"][0]["translation"] = {100, 0, 0};  // without effect
  file.addNode({{"translation", {0, 0, 5}}});
  file.addNode({{"scale", {3, 3, 3}}});
  file.root["skins"] = {{{"joints", {1, 2}}}};
  json& attributes = file.primitive()["attributes"];
  attributes["JOINTS_0"] = file.accessor<std::uint8_t>({0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, kUnsignedByte, "VEC4", 3);
  attributes["WEIGHTS_0"] = file.vectors({1, 0, 0, 0, 1, 0, 0, 0, 0.5f, 0.5f, 0, 0}, "VEC4", 4);
  return file;
}

}  // namespace

TEST_CASE("vertices follow the weighted mean of their joints") {
  CHECK(sceneOf(skinned()).meshes.at(0).positions == std::vector<glm::vec3>{{0, 0, 5}, {3, 0, 0}, {0, 2, 2.5f}});
}

TEST_CASE("inverse bind matrices come before the joints") {
  GltfFile file = skinned();
  std::vector<float> matrices(32, 0);
  for (const std::size_t i : {0u, 5u, 10u, 15u, 16u, 21u, 26u, 31u}) matrices[i] = 1;
  matrices[12] = -1;  // joint 0: x - 1
  matrices[28] = -2;  // joint 1: x - 2, which does not commute with its scale
  file.root["skins"][0]["inverseBindMatrices"] = file.accessor(matrices, kFloat, "MAT4", 2);
  const std::vector<glm::vec3> positions = sceneOf(file).meshes.at(0).positions;
  CHECK(positions[0] == glm::vec3(-1, 0, 5));
  CHECK(positions[1] == glm::vec3(-3, 0, 0));
}

TEST_CASE("weights that do not sum to 1 are scaled, and a second set counts too") {
  GltfFile file = skinned();
  json& attributes = file.primitive()["attributes"];
  attributes["WEIGHTS_0"] = file.vectors({2, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4", 4);
  attributes["JOINTS_1"] = file.accessor<std::uint16_t>({0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0}, kUnsignedShort, "VEC4",
                                                        3);
  attributes["WEIGHTS_1"] = file.vectors({0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0}, "VEC4", 4);
  CHECK(sceneOf(file).meshes.at(0).positions == std::vector<glm::vec3>{{0, 0, 5}, {3, 0, 0}, {0, 2, 2.5f}});
}

TEST_CASE("a primitive that uses a few of many vertices takes the joints and the weights of these") {
  // Joint 0 moves even vertices to z = 5, joint 1 scales odd ones by 3.
  GltfFile file = skinned();
  constexpr std::size_t kCount = 30;
  std::vector<float> positions(3 * kCount), weights(4 * kCount);
  std::vector<std::uint8_t> joints(4 * kCount);
  for (std::size_t i = 0; i < kCount; ++i) {
    positions[3 * i] = static_cast<float>(i);
    joints[4 * i] = static_cast<std::uint8_t>(i < 3 ? 1 - i % 2 : i % 2);  // other ones for the first vertices
    weights[4 * i] = 1;
  }
  json& attributes = file.primitive()["attributes"];
  attributes["POSITION"] = file.positions(positions);
  attributes["JOINTS_0"] = file.accessor(joints, kUnsignedByte, "VEC4", kCount);
  attributes["WEIGHTS_0"] = file.vectors(weights, "VEC4", 4);
  file.primitive()["indices"] = file.accessor<std::uint8_t>({13, 20, 8}, kUnsignedByte, "SCALAR", 3);
  CHECK(sceneOf(file).meshes.at(0).positions == std::vector<glm::vec3>{{8, 0, 5}, {39, 0, 0}, {20, 0, 5}});
}

TEST_CASE("a joint that mirrors keeps fronts in front") {
  GltfFile file = skinned();
  file.root["nodes"][1]["scale"] = {-1, 1, 1};
  file.root["nodes"][2]["scale"] = {-1, 1, 1};
  const scene::Scene scene = sceneOf(file);
  const scene::Triangle t = triangleOf(scene, scene.primitives[0]);
  CHECK(glm::cross(t.p[1] - t.p[0], t.p[2] - t.p[0]).z > 0);
}

}  // namespace candela::gltf

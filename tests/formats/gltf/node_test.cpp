// Nodes: transforms, scenes, instances.
#include "tests/formats/gltf/gltf_file.h"

namespace candela::gltf {
namespace {

/// Returns the position in the scene of the first vertex of the first mesh, which is the origin of its node.
glm::vec3 origin(const GltfFile& file) { return sceneOf(file).meshes.at(0).positions.at(0); }

}  // namespace

TEST_CASE("a matrix is given by columns, and T R S are applied from the right") {
  GltfFile file = triangleFile();
  file.root["nodes"][0]["matrix"] = {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 7, 8, 9, 1};
  CHECK(sceneOf(file).meshes.at(0).positions == std::vector<glm::vec3>{{7, 8, 9}, {7, 9, 9}, {6, 8, 9}});
  GltfFile same = triangleFile();
  const double a = std::sqrt(0.5);
  same.root["nodes"][0].update({{"translation", {7, 8, 9}}, {"rotation", {0, 0, a, a}}, {"scale", {2, 3, 1}}});
  const std::vector<glm::vec3> placed = sceneOf(same).meshes.at(0).positions;
  CHECK(glm::distance(placed[1], glm::vec3(7, 10, 9)) < 1e-6f);
  CHECK(glm::distance(placed[2], glm::vec3(4, 8, 9)) < 1e-6f);
}

TEST_CASE("a matrix whose last row is rounded is affine") {
  GltfFile file = triangleFile();
  file.root["nodes"][0]["matrix"] = {1, 0, 0, 1e-7, 0, 1, 0, 0, 0, 0, 1, 0, 7, 8, 9, 0.99999994};
  CHECK(origin(file) == glm::vec3(7, 8, 9));
  file.root["nodes"][0]["matrix"][15] = 0.999;
  CHECK(errorsOf(file.text()).find("/nodes/0/matrix: the last row is not 0 0 0 1") != std::string::npos);
}

TEST_CASE("lenient reading keeps a node with two parents below the first one") {
  GltfFile file = triangleFile();
  file.root["nodes"].push_back({{"children", {0}}, {"translation", {1, 0, 0}}});
  file.root["nodes"].push_back({{"children", {0}}, {"translation", {5, 0, 0}}});
  file.root["scenes"][0]["nodes"] = {1, 2};
  CHECK(errorsOf(file.text()).find("; lenient keeps it below the first one only") != std::string::npos);
  const scene::LoadedScene loaded = load(file, {.lenient = true});
  CHECK(warns(loaded, "/nodes/2/children/0: node 0 has another parent already, and stays below that one only"));
  REQUIRE(loaded.scene.meshes.size() == 1);
  CHECK(loaded.scene.meshes[0].positions[0] == glm::vec3(1, 0, 0));
}

TEST_CASE("transforms of ancestors are composed") {
  GltfFile file = triangleFile();
  file.root["nodes"][0]["translation"] = {1, 0, 0};
  file.root["nodes"].push_back({{"children", {0}}, {"scale", {2, 2, 2}}});
  file.root["nodes"].push_back({{"children", {1}}, {"translation", {0, 0, 5}}});
  file.root["scenes"][0]["nodes"] = {2};
  CHECK(origin(file) == glm::vec3(2, 0, 5));
}

TEST_CASE("only the default scene is visible, and without scenes, all nodes are") {
  GltfFile file = triangleFile();
  file.root["nodes"].push_back({{"mesh", 0}, {"translation", {0, 0, 1}}});
  CHECK(sceneOf(file).primitives.size() == 1);
  file.root["scenes"].push_back({{"nodes", {1}}});
  file.root["scene"] = 1;
  CHECK(origin(file) == glm::vec3(0, 0, 1));
  file.root.erase("scene");
  file.root.erase("scenes");
  CHECK(sceneOf(file).primitives.size() == 2);
}

TEST_CASE("a scene may list a node below a node that does not move it, with a warning") {
  GltfFile file = triangleFile();
  file.root["nodes"].push_back({{"children", {0}}, {"rotation", {0, 0, 0, 1}}});
  const scene::LoadedScene loaded = load(file);
  CHECK(warns(loaded, "/scenes/0/nodes/0: node 0 is no root"));
  CHECK(loaded.scene.primitives.size() == 1);
  file.root["scenes"][0]["nodes"] = {0, 1};
  const scene::LoadedScene both = load(file);
  CHECK(warns(both, "/scenes/0/nodes: nodes that are below other nodes of the list are shown once"));
  CHECK(both.scene.primitives.size() == 1);
}

TEST_CASE("lenient reading ignores the transforms above a node that the scene lists") {
  GltfFile file = triangleFile();
  file.root["nodes"].push_back({{"mesh", 0}, {"translation", {0, 0, 3}}});
  file.root["nodes"][0].update({{"translation", {1, 0, 0}}, {"children", {1}}});
  file.root["nodes"].push_back({{"children", {0}}, {"translation", {0, 5, 0}}});
  CHECK(errorsOf(file.text()).find("/scenes/0/nodes/0: node 0 is no root, and its ancestors have transforms") !=
        std::string::npos);
  const scene::LoadedScene loaded = load(file, {.lenient = true});
  CHECK(warns(loaded, "the transforms of its ancestors are ignored"));
  CHECK(triangleOf(loaded.scene, loaded.scene.primitives[0]).p[0] == glm::vec3(1, 0, 0));
  CHECK(triangleOf(loaded.scene, loaded.scene.primitives[1]).p[0] == glm::vec3(1, 0, 3));
}

TEST_CASE("KHR_node_visibility hides meshes and lights of a node and of those below it, but no camera") {
  GltfFile file = triangleFile();
  file.root["extensionsRequired"] = {"KHR_node_visibility"};
  file.root["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
  file.root["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}}};
  json hidden{{"mesh", 0}, {"children", {2}}};
  hidden["extensions"]["KHR_node_visibility"]["visible"] = false;
  file.root["nodes"].push_back(hidden);
  json below{{"mesh", 0}, {"camera", 0}, {"translation", {0, 0, 7}}};
  below["extensions"] = {{"KHR_lights_punctual", {{"light", 0}}}, {"KHR_node_visibility", {{"visible", true}}}};
  file.root["nodes"].push_back(below);
  file.root["scenes"][0]["nodes"] = {0, 1};
  const scene::LoadedScene loaded = load(file);
  CHECK(loaded.scene.primitives.size() == 1);
  CHECK(loaded.scene.camera->from == glm::vec3(0, 0, 7));
  CHECK(loaded.facts.at(1).second.starts_with("none in the file"));
}

TEST_CASE("a long chain of nodes is followed to its end") {
  GltfFile file = triangleFile();
  constexpr std::size_t kLength = 20000;
  for (std::size_t i = 0; i < kLength; ++i) {
    file.root["nodes"].push_back({{"children", {i}}, {"translation", {1, 0, 0}}});
  }
  file.root["scenes"][0]["nodes"] = {kLength};
  CHECK(origin(file) == glm::vec3(kLength, 0, 0));
}

TEST_CASE("each instance has its own translation, rotation and scale") {
  GltfFile file = triangleFile();
  const float a = std::sqrt(0.5f);
  const json attributes{{"TRANSLATION", file.positions({0, 0, 1, 0, 0, 2})},
                        {"ROTATION", file.vectors({0, 0, 0, 1, 0, 0, a, a}, "VEC4", 4)},
                        {"SCALE", file.positions({3, 3, 3, 1, 1, 1})}};
  file.root["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = attributes;
  file.root["nodes"][0]["translation"] = {10, 0, 0};
  const scene::Scene scene = sceneOf(file);
  CHECK(scene.meshes.size() == 1);
  REQUIRE(scene.primitives.size() == 2);
  CHECK(triangleOf(scene, scene.primitives[0]).p[1] == glm::vec3(13, 0, 1));
  CHECK(glm::distance(triangleOf(scene, scene.primitives[1]).p[1], glm::vec3(10, 1, 2)) < 1e-6f);
}

TEST_CASE("instances that have attributes of an application only are at the node") {
  GltfFile file = triangleFile();
  const std::size_t ids = file.accessor(std::vector<std::uint16_t>{7, 8}, kUnsignedShort, "SCALAR", 2);
  json& attributes = file.root["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
  attributes["_ID"] = ids;
  CHECK(sceneOf(file).primitives.size() == 2);
  attributes["TRANSLATION"] = file.positions({1, 0, 0});
  CHECK(errorsOf(file.text()).find("/attributes: attributes of 1 and 2 instances") != std::string::npos);
}

TEST_CASE("instances beyond the limit of triangles are refused before they are made") {
  constexpr std::size_t kInstances = 1u << 19;
  GltfFile file = triangleFile();
  const std::size_t indices = file.accessor(std::vector<std::uint16_t>(3 << 13), kUnsignedShort, "SCALAR", 3 << 13);
  file.primitive()["indices"] = indices;  // 8192 times the triangle of vertex 0 alone, as often as there are instances
  const std::size_t places = file.positions(std::vector<float>(3 * kInstances));
  file.root["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] = places;
  CHECK(errorsOf(file.text()).find("/nodes/0: the scene has more than 4294967294 triangles") != std::string::npos);
}

}  // namespace candela::gltf

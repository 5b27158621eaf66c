// Primitives: topologies, attributes, and how they are placed.
#include "host/formats/gltf/geometry.h"

#include <limits>

#include "tests/formats/gltf/gltf_file.h"

namespace candela::gltf {
namespace {

using Indices = std::vector<std::uint32_t>;

void checkVector(const glm::vec3& actual, const glm::vec3& expected) {
  for (glm::length_t c = 0; c < 3; ++c) CHECK(actual[c] == Approx(expected[c]).margin(1e-6));
}

/// The geometric normal of triangle 0, of any length.
glm::vec3 normalOf(const scene::Scene& scene) {
  const scene::Triangle t = triangleOf(scene, scene.primitives[0]);
  return glm::cross(t.p[1] - t.p[0], t.p[2] - t.p[0]);
}

}  // namespace

TEST_CASE("strips and fans become triangles that all face the same side") {
  CHECK(toTriangles(Topology::strip, {0, 1, 2, 3, 4}) == Indices{0, 1, 2, 1, 3, 2, 2, 3, 4});
  CHECK(toTriangles(Topology::fan, {0, 1, 2, 3}) == Indices{1, 2, 0, 2, 3, 0});
  CHECK(toTriangles(Topology::triangles, {0, 1, 2, 3, 4}) == Indices{0, 1, 2});
  CHECK(toTriangles(Topology::strip, {0, 1}).empty());
}

TEST_CASE("indices of all widths are read") {
  for (const int type : {kUnsignedByte, kUnsignedShort, kUnsignedInt}) {
    GltfFile file = triangleFile();
    std::size_t indices = 0;
    if (type == kUnsignedByte) indices = file.accessor<std::uint8_t>({2, 0, 1}, type, "SCALAR", 3);
    if (type == kUnsignedShort) indices = file.accessor<std::uint16_t>({2, 0, 1}, type, "SCALAR", 3);
    if (type == kUnsignedInt) indices = file.accessor<std::uint32_t>({2, 0, 1}, type, "SCALAR", 3);
    file.primitive()["indices"] = indices;
    CHECK(sceneOf(file).meshes.at(0).indices == Indices{2, 0, 1});
  }
}

TEST_CASE("points and lines, and primitives without positions, are not rendered, with a warning") {
  for (int mode = 0; mode < 4; ++mode) {
    GltfFile file = triangleFile();
    file.primitive()["mode"] = mode;
    const scene::LoadedScene loaded = load(file);
    CHECK(loaded.scene.primitives.empty());
    CHECK(warns(loaded, "/meshes/0/primitives/0: points and lines are not rendered"));
  }
  GltfFile file = triangleFile();
  file.primitive()["attributes"] = json::object();
  CHECK(warns(load(file), "without positions"));
}

TEST_CASE("all attributes of a vertex reach the mesh") {
  GltfFile file = triangleFile();
  json& attributes = file.primitive()["attributes"];
  attributes["NORMAL"] = file.vectors({0, 0, 2, 0, 0, 1, 0, 0, 1}, "VEC3", 3);
  attributes["TANGENT"] = file.vectors({3, 0, 0, -1, 1, 0, 0, -1, 1, 0, 0, -1}, "VEC4", 4);
  attributes["TEXCOORD_0"] = file.vectors({0, 0, 1, 0, 0, 1}, "VEC2", 2);
  const std::size_t second = file.accessor<std::uint8_t>({0, 0, 255, 0, 0, 51}, kUnsignedByte, "VEC2", 3);
  file.root["accessors"][second]["normalized"] = true;
  attributes["TEXCOORD_1"] = second;
  attributes["COLOR_0"] = file.vectors({1, 0, 0, 0, 1, 0, 0, 0, 0.5f}, "VEC3", 3);
  const scene::LoadedScene loaded = load(file);
  const scene::Mesh& mesh = loaded.scene.meshes.at(0);
  CHECK(mesh.normals == std::vector<glm::vec3>(3, {0, 0, 1}));
  CHECK(mesh.tangents == std::vector<glm::vec4>(3, {1, 0, 0, -1}));
  CHECK(mesh.texCoords[0] == std::vector<glm::vec2>{{0, 0}, {1, 0}, {0, 1}});
  CHECK(mesh.texCoords[1] == std::vector<glm::vec2>{{0, 0}, {1, 0}, {0, 0.2f}});
  CHECK(mesh.colours == std::vector<glm::vec4>{{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 0.5f, 1}});
  CHECK_FALSE(warns(loaded, "vertex colours"));
}

TEST_CASE("vertex colours are clamped to the range from 0 to 1") {
  GltfFile file = triangleFile();
  json& attributes = file.primitive()["attributes"];
  attributes["COLOR_0"] = file.vectors({2, -1, 0.5f, 1e30f, 0, 1, 0, 0.5f, -0.0f}, "VEC3", 3);
  CHECK(sceneOf(file).meshes.at(0).colours == std::vector<glm::vec4>{{1, 0, 0.5f, 1}, {1, 0, 1, 1}, {0, 0.5f, 0, 1}});
  attributes["COLOR_0"] = file.vectors({0.25f, 4, -2, 3, 1, 1, 1, -1, 0, 0, 0, 0.75f}, "VEC4", 4);
  CHECK(sceneOf(file).meshes.at(0).colours == std::vector<glm::vec4>{{0.25f, 1, 0, 1}, {1, 1, 1, 0}, {0, 0, 0, 0.75f}});
}

TEST_CASE("without normals there are no tangents, and the triangle is flat") {
  GltfFile file = triangleFile();
  file.primitive()["attributes"]["TANGENT"] = file.vectors({1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1}, "VEC4", 4);
  const scene::Scene scene = sceneOf(file);
  CHECK(scene.meshes.at(0).tangents.empty());
  CHECK_FALSE(isSmooth(scene, scene.primitives[0]));
}

TEST_CASE("normals follow a scale by its inverse, and tangents by the scale itself") {
  GltfFile file = triangleFile();
  json& attributes = file.primitive()["attributes"];
  const float a = std::sqrt(0.5f);
  attributes["NORMAL"] = file.vectors({a, a, 0, a, a, 0, a, a, 0}, "VEC3", 3);
  attributes["TANGENT"] = file.vectors({a, -a, 0, 1, a, -a, 0, 1, a, -a, 0, 1}, "VEC4", 4);
  file.root["nodes"][0]["scale"] = {2, 1, 1};
  const scene::Scene scene = sceneOf(file);
  const scene::Mesh& mesh = scene.meshes.at(0);
  checkVector(mesh.normals[0], glm::normalize(glm::vec3(0.5f, 1, 0)));
  checkVector(glm::vec3(mesh.tangents[0]), glm::normalize(glm::vec3(2, -1, 0)));
  CHECK(glm::dot(mesh.normals[0], glm::vec3(mesh.tangents[0])) == Approx(0).margin(1e-6));
  CHECK(mesh.tangents[0].w == 1);
}

TEST_CASE("a mirrored mesh keeps its front: vertices change their order, tangents their handedness") {
  GltfFile file = triangleFile();
  json& attributes = file.primitive()["attributes"];
  attributes["NORMAL"] = file.vectors({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3", 3);
  attributes["TANGENT"] = file.vectors({1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1}, "VEC4", 4);
  file.root["nodes"][0]["scale"] = {-1, 1, 1};
  const scene::Scene scene = sceneOf(file);
  checkVector(normalOf(scene), {0, 0, 1});
  checkVector(scene.meshes.at(0).normals[0], {0, 0, 1});
  CHECK(scene.meshes[0].tangents[0] == glm::vec4(-1, 0, 0, -1));
  file.root["nodes"][0]["scale"] = {1, 1, -1};  // the front now faces -z
  checkVector(normalOf(sceneOf(file)), {0, 0, -1});
  checkVector(sceneOf(file).meshes.at(0).normals[0], {0, 0, -1});
}

TEST_CASE("a normal without length is replaced by that of a triangle") {
  GltfFile file = triangleFile();
  file.primitive()["attributes"]["NORMAL"] = file.vectors({0, 0, 0, 0, 1, 0, 0, 1, 0}, "VEC3", 3);
  const scene::Scene scene = sceneOf(file);
  checkVector(scene.meshes.at(0).normals[0], {0, 0, 1});
  checkVector(scene.meshes[0].normals[1], {0, 1, 0});
}

TEST_CASE("lenient reading takes normals and tangents that are not finite for 0") {
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
  GltfFile file = triangleFile();
  json& attributes = file.primitive()["attributes"];
  attributes["NORMAL"] = file.vectors({0, nan, 1, 0, 1, 0, 0, 1, 0}, "VEC3", 3);
  attributes["TANGENT"] = file.vectors({1, 0, 0, 1, 1, 0, 0, 1, 1, -infinity, 0, 1}, "VEC4", 4);
  const std::string message = "/accessors/" + attributes["NORMAL"].dump() + ": element 0 is not finite";
  CHECK_THAT(errorsOf(file.text()), Catch::Contains(message + "; lenient reads it as 0"));
  const scene::LoadedScene loaded = load(file, {.lenient = true});
  CHECK(warns(loaded, message));
  const scene::Mesh& mesh = loaded.scene.meshes.at(0);
  checkVector(mesh.normals.at(0), {0, 0, 1});
  checkVector(mesh.normals[1], {0, 1, 0});
  CHECK(glm::vec3(mesh.tangents.at(2)) == glm::vec3(0));
  CHECK(mesh.tangents[0] == glm::vec4(1, 0, 0, 1));
  attributes["POSITION"] = attributes["NORMAL"];
  CHECK_THAT(errorsOf(file.text(), {.lenient = true}), Catch::EndsWith("element 0 is not finite"));
}

TEST_CASE("morph targets add to positions by the weights of the mesh, or those of the node") {
  GltfFile file = triangleFile();
  file.primitive()["targets"] = {{{"POSITION", file.positions({0, 0, 1, 0, 0, 2, 0, 0, 3})}},
                                 {{"POSITION", file.positions({5, 0, 0, 0, 0, 0, 0, 0, 0})}}};
  CHECK(sceneOf(file).meshes.at(0).positions[2] == glm::vec3(0, 1, 0));
  file.root["meshes"][0]["weights"] = {0.5, 0};
  CHECK(sceneOf(file).meshes.at(0).positions == std::vector<glm::vec3>{{0, 0, 0.5f}, {1, 0, 1}, {0, 1, 1.5f}});
  file.root["nodes"][0]["weights"] = {0, 1};
  CHECK(sceneOf(file).meshes.at(0).positions[0] == glm::vec3(5, 0, 0));
}

TEST_CASE("morph targets add to colours, which are clamped afterwards, and to texture coordinates") {
  GltfFile file = triangleFile();
  json& attributes = file.primitive()["attributes"];
  attributes["COLOR_0"] = file.vectors({1, 0, 0, 0, 0.5f, 0, 0, 0, 1.5f}, "VEC3", 3);
  attributes["TEXCOORD_0"] = file.vectors({0, 0, 1, 0, 0, 1}, "VEC2", 2);
  attributes["TEXCOORD_1"] = file.vectors({0, 0, 0, 0, 0, 0}, "VEC2", 2);
  file.primitive()["targets"] = {{{"COLOR_0", file.vectors({-1, 1, 0, 0, 4, 0, 0, 0, -2}, "VEC3", 3)},
                                  {"TEXCOORD_0", file.vectors({1, 2, 0, 0, 0, 4}, "VEC2", 2)}},
                                 {{"COLOR_0", file.vectors({0, 0, 0, -1, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC4", 4)},
                                  {"TEXCOORD_1", file.vectors({0, 1, 0, 0, 0, 0}, "VEC2", 2)}}};
  file.root["meshes"][0]["weights"] = {0.5, 0.25};
  const scene::Scene scene = sceneOf(file);
  const scene::Mesh& mesh = scene.meshes.at(0);
  // The third colour is 1.5 - 1: it is clamped after the target has moved it.
  CHECK(mesh.colours == std::vector<glm::vec4>{{0.5f, 0.5f, 0, 0.75f}, {0, 1, 0, 1}, {0, 0, 0.5f, 1}});
  CHECK(mesh.texCoords[0] == std::vector<glm::vec2>{{0.5f, 1}, {1, 0}, {0, 3}});
  CHECK(mesh.texCoords[1] == std::vector<glm::vec2>{{0, 0.25f}, {0, 0}, {0, 0}});
  file.primitive()["targets"][0]["COLOR_0"] = file.vectors({1, 1, 1}, "VEC3", 3);
  CHECK_THAT(errorsOf(file.text()), Catch::Contains("1 values for 3 vertices"));
}

TEST_CASE("morph targets add to normals and to the directions of tangents, whose lengths are 1 afterwards") {
  GltfFile file = triangleFile();
  json& attributes = file.primitive()["attributes"];
  attributes["NORMAL"] = file.vectors({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3", 3);
  attributes["TANGENT"] = file.vectors({1, 0, 0, -1, 1, 0, 0, -1, 1, 0, 0, -1}, "VEC4", 4);
  file.primitive()["targets"] = {{{"NORMAL", file.positions({4, 0, 0, 0, 6, 0, 0, 0, 0})},
                                  {"TANGENT", file.positions({0, 0, -4, 0, 0, 0, 0, 1.5f, 0})}}};
  file.root["meshes"][0]["weights"] = {0.5};
  const scene::Scene scene = sceneOf(file);
  const scene::Mesh& mesh = scene.meshes.at(0);
  checkVector(mesh.normals.at(0), glm::normalize(glm::vec3(2, 0, 1)));
  checkVector(mesh.normals[1], glm::normalize(glm::vec3(0, 3, 1)));
  checkVector(mesh.normals[2], {0, 0, 1});
  checkVector(glm::vec3(mesh.tangents.at(0)), glm::normalize(glm::vec3(1, 0, -2)));
  checkVector(glm::vec3(mesh.tangents[1]), {1, 0, 0});
  checkVector(glm::vec3(mesh.tangents[2]), {0.8f, 0.6f, 0});
  for (const glm::vec4& tangent : mesh.tangents) CHECK(tangent.w == -1);
}

TEST_CASE("a morph target's attribute that the primitive lacks is named in a warning, if its weight is not 0") {
  GltfFile file = triangleFile();
  file.primitive()["targets"] = {{{"POSITION", file.positions({0, 0, 1, 0, 0, 2, 0, 0, 3})},
                                  {"COLOR_0", file.vectors({1, 1, 1, 1, 1, 1, 1, 1, 1}, "VEC3", 3)}},
                                 {{"TEXCOORD_1", file.vectors({0, 1, 0, 0, 0, 0}, "VEC2", 2)}}};
  file.root["meshes"][0]["weights"] = {0, 0};
  CHECK(load(file).warnings.empty());
  file.root["meshes"][0]["weights"] = {0.5, 0};
  CHECK(warns(load(file), "/meshes/0/primitives/0/targets/0/COLOR_0 is left out: the primitive has no such attribute"));
  CHECK(sceneOf(file).meshes.at(0).positions[2] == glm::vec3(0, 1, 1.5f));
  CHECK(sceneOf(file).meshes.at(0).colours.empty());
  file.root["meshes"][0]["weights"] = {0, 1};
  CHECK(warns(load(file), "/targets/1/TEXCOORD_1 is left out"));
  for (const char* name : {"NORMAL", "TANGENT", "TEXCOORD_0"}) {
    GltfFile other = triangleFile();
    other.primitive()["targets"] = {{{name, other.positions({0, 0, 1, 0, 0, 2, 0, 0, 3})}}};
    other.root["meshes"][0]["weights"] = {1};
    CAPTURE(name);
    CHECK(warns(load(other), std::string("/targets/0/") + name + " is left out"));
  }
}

TEST_CASE("quantised positions are scaled by their node") {
  GltfFile file;
  const std::size_t positions = file.accessor<std::int16_t>({0, 0, 0, 0, 32767, 0, 0, 0, 0, -32768, 0, 0}, kShort,
                                                            "VEC3", 3);
  file.root["accessors"][positions]["normalized"] = true;
  file.root["bufferViews"][0]["byteStride"] = 8;
  file.root["extensionsRequired"] = {"KHR_mesh_quantization"};
  file.addMesh({{"attributes", {{"POSITION", positions}}}})["scale"] = {10, 10, 10};
  CHECK(sceneOf(file).meshes.at(0).positions == std::vector<glm::vec3>{{0, 0, 0}, {10, 0, 0}, {0, -10, 0}});
}

TEST_CASE("influences are read for skins only, and only sixteen sets of them") {
  GltfFile file = triangleFile();
  json& attributes = file.primitive()["attributes"];
  for (int set = 0; set < 17; ++set) {
    attributes["JOINTS_" + std::to_string(set)] = file.accessor<std::uint8_t>(std::vector<std::uint8_t>(12),
                                                                              kUnsignedByte, "VEC4", 3);
    attributes["WEIGHTS_" + std::to_string(set)] = file.vectors(std::vector<float>(12, 1), "VEC4", 4);
  }
  CHECK(sceneOf(file).meshes.size() == 1);
  file.root["skins"] = json::array({{{"joints", {0}}}});
  file.root["nodes"][0]["skin"] = 0;
  CHECK_THAT(errorsOf(file.text()),
             Catch::Contains("/meshes/0/primitives/0/attributes/JOINTS_16: at most 16 sets of joints are read"));
  attributes.erase("JOINTS_16");
  CHECK(sceneOf(file).meshes.size() == 1);
}

}  // namespace candela::gltf

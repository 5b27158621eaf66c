// Vertices that primitives share or do not use, and the limits of what is read.
#include <array>
#include <limits>
#include <random>

#include "host/base/memory_budget.h"
#include "tests/formats/gltf/gltf_file.h"

namespace candela::gltf {

TEST_CASE("unused vertices are removed if there are many") {
  GltfFile file;
  std::vector<float> xyz(300);
  for (std::size_t i = 0; i < xyz.size(); ++i) xyz[i] = static_cast<float>(i * i % 97);
  const std::size_t positions = file.positions(xyz);
  const std::size_t indices = file.accessor<std::uint16_t>({90, 7, 45}, kUnsignedShort, "SCALAR", 3);
  file.addMesh({{"attributes", {{"POSITION", positions}}}, {"indices", indices}});
  const scene::Scene scene = sceneOf(file);
  CHECK(scene.meshes.at(0).positions.size() == 3);
  const scene::Triangle triangle = triangleOf(scene, scene.primitives[0]);
  CHECK(triangle.p[0] == glm::vec3(xyz[270], xyz[271], xyz[272]));
  CHECK(triangle.p[1] == glm::vec3(xyz[21], xyz[22], xyz[23]));
}

TEST_CASE("elements without a buffer view are read up to a total of the file") {
  constexpr std::size_t kMaxZeros = 1u << 24;
  GltfFile file = triangleFile();
  json& accessors = file.root["accessors"];
  const auto zeros = [&](const char* type, int component, std::size_t count) {
    accessors.push_back({{"componentType", component}, {"count", count}, {"type", type}});
    return accessors.size() - 1;
  };
  file.primitive()["attributes"]["POSITION"] = zeros("VEC3", kFloat, kMaxZeros - 2);
  file.primitive()["indices"] = zeros("SCALAR", kUnsignedShort, 3);
  CHECK_THAT(
      errorsOf(file.text()),
      Catch::Contains("/accessors/" + std::to_string(accessors.size() - 2) +
                      "/count: 16777214 elements without a buffer view, after 3 others; at most 16777216 are read"));
}

TEST_CASE("a primitive with many unused vertices is read once for all nodes") {
  constexpr std::size_t kVertices = std::size_t{1} << 22;  // four nodes would read more than 2^24 elements
  GltfFile file = triangleFile();
  file.root["accessors"].push_back({{"componentType", kFloat}, {"count", kVertices}, {"type", "VEC3"}});
  file.primitive()["attributes"]["POSITION"] = file.root["accessors"].size() - 1;
  file.primitive()["indices"] = file.accessor<std::uint8_t>({2, 0, 1}, kUnsignedByte, "SCALAR", 3);
  for (int i = 0; i < 9; ++i) {
    file.root["nodes"].push_back({{"mesh", 0}});
    file.root["scenes"][0]["nodes"].push_back(file.root["nodes"].size() - 1);
  }
  const scene::Scene scene = sceneOf(file);
  REQUIRE(scene.meshes.size() == 1);
  CHECK(scene.meshes.back().positions.size() == 3);
  CHECK(scene.primitives.size() == 10);
}

TEST_CASE("vertices that many primitives or many morph weights share are read once") {
  constexpr std::size_t kVertices = std::size_t{1} << 22;  // four primitives would read more than 2^24 elements
  GltfFile file = triangleFile();
  file.root["accessors"].push_back({{"componentType", kFloat}, {"count", kVertices}, {"type", "VEC3"}});
  json& first = file.primitive();
  first["attributes"]["POSITION"] = file.root["accessors"].size() - 1;
  first["targets"] = {{{"POSITION", file.root["accessors"].size() - 1}}};
  json& primitives = file.root["meshes"][0]["primitives"];
  SECTION("primitives") {
    const json shared = first;
    for (std::uint8_t i = 0; i < 9; ++i) {
      primitives[i] = shared;
      primitives[i]["indices"] = file.accessor<std::uint8_t>({2, i, 1}, kUnsignedByte, "SCALAR", 3);
    }
    REQUIRE(sceneOf(file).meshes.size() == 9);
  }
  SECTION("weights") {
    first["indices"] = file.accessor<std::uint8_t>({2, 0, 1}, kUnsignedByte, "SCALAR", 3);
    for (int i = 1; i < 9; ++i) file.addNode({{"mesh", 0}, {"weights", {i}}});
    REQUIRE(sceneOf(file).meshes.size() == 9);
  }
}

TEST_CASE("each primitive has its own vertices of a set that is shared") {
  GltfFile file;
  std::mt19937 random(1);
  std::uniform_real_distribution<float> between(0.1f, 0.9f);
  const auto numbers = [&](std::size_t count) {
    std::vector<float> values(count);
    for (float& value : values) value = between(random);
    return values;
  };
  constexpr std::size_t kVertices = 50;
  const std::vector<float> xyz = numbers(3 * kVertices), uv = numbers(2 * kVertices), rgba = numbers(4 * kVertices);
  std::vector<float> moves(3 * kVertices, 0);
  moves[3 * 40 + 2] = 8;  // of the vertex 40 along z
  const std::size_t target = file.positions(moves);
  file.root["accessors"][target]["sparse"] = {
      {"count", 1},
      {"indices", {{"bufferView", file.view<std::uint8_t>({41})}, {"componentType", kUnsignedByte}}},
      {"values", {{"bufferView", file.view<float>({0, 0, 16})}}}};
  const json attributes = {{"POSITION", file.positions(xyz)},
                           {"TEXCOORD_0", file.vectors(uv, "VEC2", 2)},
                           {"COLOR_0", file.vectors(rgba, "VEC4", 4)}};
  json primitives = json::array();
  constexpr std::array<std::uint8_t, 3> kLast{49, 12, 40};
  for (const std::uint8_t last : kLast) {
    const std::size_t indices = file.accessor<std::uint8_t>({41, last, 3}, kUnsignedByte, "SCALAR", 3);
    primitives.push_back({{"attributes", attributes}, {"indices", indices}, {"targets", {{{"POSITION", target}}}}});
  }
  file.root["meshes"] = {{{"primitives", primitives}, {"weights", {0.5}}}};
  file.addNode({{"mesh", 0}});
  const scene::Scene scene = sceneOf(file);
  for (std::size_t i = 0; i < 3; ++i) {
    const scene::Mesh& mesh = scene.meshes.at(i);
    REQUIRE(mesh.positions.size() == 3);
    const std::size_t sources[] = {41, kLast[i], 3};
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::size_t v = sources[corner], own = mesh.indices.at(corner);
      const float moved = v == 40 ? 4.0f : v == 41 ? 8.0f : 0.0f;
      CHECK(mesh.positions[own] == glm::vec3(xyz[3 * v], xyz[3 * v + 1], xyz[3 * v + 2] + moved));
      CHECK(mesh.texCoords[0].at(own) == glm::vec2(uv[2 * v], uv[2 * v + 1]));
      CHECK(mesh.colours.at(own) == glm::vec4(rgba[4 * v], rgba[4 * v + 1], rgba[4 * v + 2], rgba[4 * v + 3]));
    }
  }
}

TEST_CASE("vertices that no triangle uses are checked, too") {
  GltfFile file;
  std::vector<float> xyz(300, 1);
  xyz[200] = std::numeric_limits<float>::infinity();
  const std::size_t positions = file.positions(xyz);
  const std::size_t indices = file.accessor<std::uint8_t>({0, 1, 2}, kUnsignedByte, "SCALAR", 3);
  file.addMesh({{"attributes", {{"POSITION", positions}}}, {"indices", indices}});
  CHECK_THAT(errorsOf(file.text()), Catch::Contains("element 66 is not finite"));
}

TEST_CASE("a primitive beyond the memory budget is refused before it is read") {
  GltfFile file = triangleFile();
  limitMemory(1);
  CHECK_THROWS_WITH(load(file), Catch::Contains("/meshes/0/primitives/0: with this primitive, the scene needs about"));
  limitMemory(0);
}

}  // namespace candela::gltf

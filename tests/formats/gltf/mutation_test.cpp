// Files that are cut off or changed at random are read or refused, but never do harm.
#include <random>

#include "tests/formats/gltf/gltf_file.h"

namespace candela::gltf {
namespace {

/// A file that uses most of the reader.
GltfFile richFile() {
  GltfFile file = triangleFile();
  json& primitive = file.primitive();
  primitive["indices"] = file.accessor<std::uint8_t>({0, 1, 2}, kUnsignedByte, "SCALAR", 3);
  primitive["targets"] = {{{"POSITION", file.positions({1, 1, 1, 1, 1, 1, 1, 1, 1})}}};
  primitive["attributes"]["NORMAL"] = file.vectors({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3", 3);
  primitive["attributes"]["JOINTS_0"] = file.accessor<std::uint8_t>(std::vector<std::uint8_t>(12, 0), kUnsignedByte,
                                                                    "VEC4", 3);
  primitive["attributes"]["WEIGHTS_0"] = file.vectors(std::vector<float>(12, 0.25f), "VEC4", 4);
  file.root["nodes"][0]["skin"] = 0;
  file.root["nodes"][0]["weights"] = {0.5};
  file.addNode({{"children", json::array()}, {"rotation", {0, 0, 0, 1}}});
  file.root["skins"] = {{{"joints", {1}}}};
  file.root["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"aspectRatio", 1.5}}}}};
  file.addNode({{"camera", 0}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 5, 1}}});
  const std::size_t times = file.vectors({0, 1}, "SCALAR", 1);
  const std::size_t values = file.positions({0, 0, 0, 1, 1, 1});
  file.root["animations"] = {{{"channels", {{{"sampler", 0}, {"target", {{"node", 1}, {"path", "translation"}}}}}},
                              {"samplers", {{{"input", times}, {"output", values}}}}}};
  return file;
}

/// Reads a file; whatever it reads must be consistent.
void survive(const std::string& bytes) {
  try {
    const scene::Scene scene = loadText(bytes, {.time = 0.5}).scene;
    for (const scene::Primitive& primitive : scene.primitives) {
      REQUIRE(primitive.material < scene.materials.size());
      for (std::uint32_t c = 0; c < 3; ++c) {
        REQUIRE(vertexIndex(meshOf(scene, primitive), primitive.index, c) < meshOf(scene, primitive).positions.size());
      }
    }
  } catch (const FileError& error) {
    REQUIRE(error.code() == ExitCode::file);
    REQUIRE(std::string(error.what()).starts_with("test.gltf:"));
  }
}

/// Replaces one value somewhere in a JSON tree.
void mutate(json& tree, std::mt19937& random) {
  static const std::vector<json> kValues{-1,     0,      1,    2147483648u, 4294967296ull, 1e300,         0.5,
                                         "VEC3", "data", true, nullptr,     json::array(), json::object()};
  if (tree.empty() || !tree.is_structured() || random() % 6 == 0) {
    tree = kValues[random() % kValues.size()];
    return;
  }
  auto chosen = tree.begin();
  std::advance(chosen, static_cast<long>(random() % tree.size()));
  mutate(*chosen, random);
}

}  // namespace

TEST_CASE("the file of the mutations is good") { CHECK(errorsOf(richFile().text(), {.time = 0.5}).empty()); }

TEST_CASE("files that end anywhere are refused") {
  const std::string glb = richFile().glb();
  for (std::size_t length = 0; length < glb.size(); ++length) survive(glb.substr(0, length));
  const std::string text = richFile().text();
  for (std::size_t length = 0; length < text.size(); length += 7) survive(text.substr(0, length));
}

TEST_CASE("files with a changed value are read or refused") {
  std::mt19937 random(17);
  for (int i = 0; i < 20000; ++i) {
    GltfFile file = richFile();
    for (std::size_t n = random() % 3 + 1; n > 0; --n) mutate(file.root, random);
    survive(file.text());
  }
}

TEST_CASE("files with changed bytes are read or refused") {
  std::mt19937 random(18);
  const std::string good = richFile().glb();
  for (int i = 0; i < 20000; ++i) {
    std::string bytes = good;
    for (std::size_t n = random() % 4 + 1; n > 0; --n) bytes[random() % bytes.size()] = static_cast<char>(random());
    survive(bytes);
  }
}

}  // namespace candela::gltf

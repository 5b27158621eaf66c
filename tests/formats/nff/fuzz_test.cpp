// No damage to a scene file crashes the reader: it is loaded, or refused with a message.
#include <catch2/catch.hpp>
#include <map>
#include <random>

#include "tests/base/temporary_folder.h"
#include "tests/formats/nff/scene_text.h"

namespace candela::scene {
namespace {

/// The start of each scene file, so that a test takes well under a second.
std::vector<std::string> seeds() {
  std::vector<std::string> texts;
  for (const char* folder : {"scenes", "tests/formats/nff/spd"}) {
    for (const auto& file : filesIn(folder)) texts.push_back(readText(file).substr(0, 3000));
  }
  return texts;
}

void checkMesh(const Mesh& mesh) {
  REQUIRE((mesh.indices.empty() ? mesh.positions.size() : mesh.indices.size()) % 3 == 0);
  REQUIRE((mesh.normals.empty() || mesh.normals.size() == mesh.positions.size()));
  for (const std::uint32_t index : mesh.indices) REQUIRE(index < mesh.positions.size());
}

std::size_t shapeCount(const Scene& scene, const Primitive& primitive) {
  if (primitive.kind == PrimitiveKind::triangle) return triangleCount(scene.meshes.at(primitive.mesh));
  const std::map<PrimitiveKind, std::size_t> counts{{PrimitiveKind::sphere, scene.spheres.size()},
                                                    {PrimitiveKind::box, scene.boxes.size()},
                                                    {PrimitiveKind::cone, scene.cones.size()},
                                                    {PrimitiveKind::plane, scene.planes.size()}};
  return counts.at(primitive.kind);
}

void checkIndices(const Scene& scene) {
  for (const Mesh& mesh : scene.meshes) checkMesh(mesh);
  for (const Primitive& primitive : scene.primitives) {
    REQUIRE(primitive.index < shapeCount(scene, primitive));
    REQUIRE(primitive.material < scene.materials.size());
  }
}

void checkSurvives(const std::string& text) {
  for (const bool lenient : {false, true}) {
    try {
      checkIndices(parseScene(text, "fuzz", ".", {.lenient = lenient}).scene);
    } catch (const FileError& error) {
      REQUIRE(*error.what() != '\0');
    }
  }
}

std::string mutated(std::string text, std::mt19937& random) {
  static const std::vector<std::string> kPieces{"",      " ",          "\n",        "#",
                                                "-",     "9999999999", "nan",       "1e39",
                                                "-1",    "0",          "p 5000000", "mesh 4000000000 1",
                                                "v",     "f",          "env ..",    std::string("\0", 1),
                                                "\xff",  "s",          "pp 16384",  "spp -1",
                                                "accel", "1e-400",     "light quad"};
  const auto below = [&](std::size_t n) { return n == 0 ? 0 : random() % n; };
  const std::size_t edits = 1 + below(4);
  for (std::size_t i = 0; i < edits; ++i) {
    text.replace(below(text.size()), below(12), kPieces[below(kPieces.size())]);
  }
  return text;
}

}  // namespace

TEST_CASE("scene files cut off anywhere load or are refused") {
  for (const std::string& text : seeds()) {
    for (std::size_t length = 0; length < text.size(); length += 41) checkSurvives(text.substr(0, length));
  }
}

TEST_CASE("scene files with random damage load or are refused") {
  std::mt19937 random(20260);
  for (const std::string& text : seeds()) {
    for (int i = 0; i < 60; ++i) checkSurvives(mutated(text, random));
  }
}

TEST_CASE("random bytes are refused or load") {
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i) {
    std::string text(random() % 400, '\0');
    for (char& c : text) c = static_cast<char>(random());
    checkSurvives(text);
  }
}

TEST_CASE("absurd counts are refused before anything is allocated") {
  for (const char* text : {"mesh 4000000000 1\n", "mesh 1 4000000000\n0 0 0\n", "p 999999999\n", "pp 16384\n"}) {
    CHECK(errorsOf(text).size() == 1);
  }
}

}  // namespace candela::scene

// The scenes of the project, and small files of the Standard Procedural Databases, have the expected content.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "host/formats/load_scene.h"
#include "tests/formats/loading/triangles.h"
#include "tests/formats/nff/scene_text.h"

namespace candela::scene {
namespace {

LoadedScene loadFile(const std::string& path) {
  return formats::loadScene(std::filesystem::path(CANDELA_SOURCE_DIR) / path);
}

LoadedScene loadSpd(const std::string& name) { return loadFile("tests/formats/nff/spd/" + name + ".nff"); }

}  // namespace

TEST_CASE("all scenes of the project load strictly, with a view and without warnings") {
  const auto files = filesIn("scenes");
  REQUIRE(files.size() >= 11);
  for (const auto& file : files) {
    CAPTURE(file);
    const LoadedScene loaded = formats::loadScene(file);
    for (const Diagnostic& warning : loaded.warnings) UNSCOPED_INFO(toString(warning));
    CHECK(loaded.warnings.empty());
    CHECK(loaded.scene.camera);
    CHECK(loaded.scene.name == file.filename().string());
    CHECK(loaded.scene.hash != 0);
  }
}

TEST_CASE("the Cornell box has 38 triangles, two of which emit") {
  const Scene scene = loadFile("scenes/cornell.p3f").scene;
  CHECK(trianglesOf(scene).size() == 38);
  CHECK(scene.primitives.size() == 38);
  CHECK(std::ranges::count_if(scene.primitives,
                              [&](const Primitive& p) { return isEmissive(scene.materials[p.material]); }) == 2);
}

TEST_CASE("smallpt's box is nine spheres seen through the back of its front wall") {
  const Scene scene = loadFile("scenes/smallpt.p3f").scene;
  REQUIRE(scene.spheres.size() == 9);
  CHECK(scene.primitives.size() == 9);
  CHECK(std::ranges::count_if(scene.spheres, [](const Sphere& s) { return s.radius < 0; }) == 1);
  const Camera& camera = *scene.camera;
  const glm::dvec3 direction = glm::normalize(glm::dvec3(camera.at) - glm::dvec3(camera.from));
  const glm::dvec3 expected = glm::normalize(glm::dvec3(0, -0.042612, -1));
  CHECK(glm::length(direction - expected) < 1e-6);
  const double halfAngle = static_cast<double>(camera.angle) / 2 * std::numbers::pi / 180;
  CHECK(2 * std::tan(halfAngle) == Approx(0.5135).epsilon(1e-6));
}

TEST_CASE("files of the Standard Procedural Databases have the counts of their definitions") {
  const LoadedScene balls = loadSpd("balls_2");  // 1 + 9 + 81 spheres on one quad
  CHECK(balls.counts.at("sphere") == 91);
  CHECK(balls.scene.spheres.size() == 91);
  CHECK(trianglesOf(balls.scene).size() == 2);
  CHECK(balls.scene.pointLights.size() == 3);

  const LoadedScene gears = loadSpd("gears_1");  // a floor, and one gear: two 144-gons, 144 quads
  CHECK(gears.counts.at("polygon") == 147);
  CHECK(trianglesOf(gears.scene).size() == 2 + 2 * 142 + 144 * 2);

  const LoadedScene rings = loadSpd("rings_1");  // 5 s (s+1) (2s+1) spheres and as many cylinders
  CHECK(rings.scene.spheres.size() == 30);
  CHECK(rings.scene.cones.size() == 30);

  const LoadedScene tree = loadSpd("tree_3");  // 2^(s+1) - 1 cones and spheres
  CHECK(tree.scene.cones.size() == 15);
  CHECK(tree.scene.spheres.size() == 15);

  const LoadedScene mount = loadSpd("mount_3");  // 2 * 4^s triangles, four spheres
  CHECK(trianglesOf(mount.scene).size() == 128);
  CHECK(mount.scene.spheres.size() == 4);

  CHECK(loadSpd("shells_1").scene.spheres.size() == 361);
  CHECK(loadSpd("jacks_1").counts.at("cone") == 3);
  const LoadedScene teapot = loadSpd("teapot_1");
  CHECK(teapot.counts.at("patch") == 56);
  CHECK(vertexNormalsOf(teapot.scene).size() + 2 == trianglesOf(teapot.scene).size());
}

TEST_CASE("the views and colours of a database file are read exactly") {
  const Scene scene = loadSpd("balls_2").scene;
  CHECK(scene.background == glm::vec3(.078f, .361f, .753f));
  CHECK(scene.camera->from == glm::vec3(2.1f, 1.3f, 1.7f));
  CHECK(scene.pointLights.at(1).position == glm::vec3(1, -4, 4));
  CHECK(scene.materials.at(0).whitted->shine == 100000);
}

TEST_CASE("a million triangles load in seconds", "[slow]") {
  std::string text = "mesh 1000000 1000000\n";
  for (int i = 0; i < 1'000'000; ++i) text += "1.234567 -2.345678 3.456789\n";
  for (int i = 0; i < 1'000'000; ++i) text += "1 500000 -1\n";
  CHECK(trianglesOf(sceneOf(text)).size() == 1'000'000);
}

}  // namespace candela::scene

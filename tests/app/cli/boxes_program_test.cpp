// `candela boxes` as a user runs it: the boxes, their positions, and errors.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "host/formats/load_scene.h"
#include "host/formats/nff/nff_loader.h"
#include "host/image/image.h"
#include "host/trace/accel/primitive_bounds.h"
#include "host/trace/flatten/flatten_hierarchy.h"
#include "tests/app/cli/run_program.h"

namespace candela {
namespace {

const std::string kView = "v\nfrom 0.1 -4 1\nat 0 0 0\nup 0 0 1\nangle 40\nhither 1\nresolution 16 12\n";

scene::Scene boxesOf(const std::string& scene, const std::vector<std::string>& options = {}) {
  const TemporaryFolder folder;
  std::vector<std::string> words{"boxes", folder.write("a.nff", scene), "-o", folder.path("boxes.nff")};
  words.insert(words.end(), options.begin(), options.end());
  const ProgramResult result = runCandela(words);
  INFO(result.err);
  REQUIRE(result.exitCode == 0);
  return formats::loadScene(folder.path("boxes.nff")).scene;
}

// Twenty balls along a line at increasing distances.
std::string row() {
  std::string text = kView;
  for (int i = 0; i < 20; ++i) text += "s " + std::to_string(0.01 * i * i * i) + " 0 0 0.1\n";
  return text;
}

}  // namespace

TEST_CASE("the edges of a box end exactly at its corners") {
  const std::string text = kView + "s 0.3 -0.7 123.4 0.125\n";
  const accel::Aabb box = accel::boundPrimitives(scene::parseScene(text, "a", ".").scene).bounds.front();
  const scene::Scene drawn = boxesOf(text);
  REQUIRE(drawn.cones.size() == 12);
  for (const bool lowX : {false, true}) {
    for (const bool lowY : {false, true}) {
      for (const bool lowZ : {false, true}) {
        const glm::vec3 corner(lowX ? box.min.x : box.max.x, lowY ? box.min.y : box.max.y,
                               lowZ ? box.min.z : box.max.z);
        CHECK(std::ranges::count_if(drawn.cones,
                                    [&](const scene::Cone& c) { return c.base == corner || c.apex == corner; }) == 3);
      }
    }
  }
}

TEST_CASE("a flat box has no edges along its flat axis") {
  // At the origin nothing pads the box.
  CHECK(boxesOf(kView + "p 3\n0 0 0\n1 0 0\n0 0 1\n").cones.size() == 12);
  CHECK(boxesOf(kView + "p 3\n0 0 0\n0 0 0\n0 0 0\n").cones.empty());
  CHECK(boxesOf(kView + "pl 0 0 0  1 0 0  0 1 0\n").cones.empty());
}

TEST_CASE("the boxes are those of the BVH that the renderer builds") {
  const std::vector<accel::Aabb> bounds = accel::boundPrimitives(scene::parseScene(row(), "a", ".").scene).bounds;
  const auto nodesBy = [&](render::BvhSplit split) {
    return flatten::buildHierarchy(bounds, split, render::BuildQuality::standard).nodes.size();
  };
  CHECK(nodesBy(render::BvhSplit::sah) != nodesBy(render::BvhSplit::midpoint));
  CHECK(boxesOf(row()).cones.size() == 12 * nodesBy(render::BvhSplit::sah));
  CHECK(boxesOf(row(), {"--bvh-split", "midpoint"}).cones.size() == 12 * nodesBy(render::BvhSplit::midpoint));
  CHECK(boxesOf(row(), {"--depth", "0"}).cones.size() == 12);
  CHECK(boxesOf(row(), {"--depth", "1"}).cones.size() == 24);
}

TEST_CASE("the scene of boxes has the view of the original scene, and both tracers show it") {
  const std::string scene = row();
  const scene::Scene drawn = boxesOf(scene);
  const scene::Camera camera = *scene::parseScene(scene, "a", ".").scene.camera;
  CHECK(drawn.camera->from == camera.from);
  CHECK(drawn.camera->up == camera.up);
  CHECK(drawn.camera->angle == camera.angle);
  CHECK(drawn.camera->width == 16);
  CHECK(drawn.camera->height == 12);

  const TemporaryFolder folder;
  const std::string boxes = folder.path("boxes.nff");
  REQUIRE(runCandela({"boxes", folder.write("a.nff", scene), "-o", boxes}).exitCode == 0);
  for (const char* integrator : {"path", "whitted"}) {
    const std::string image = folder.path("a.pfm");
    const std::vector<std::string> words{boxes,    "--device", "cpu", "--integrator", integrator,
                                         "--size", "128x96",   "-o",  image};
    REQUIRE(runCandela(words).exitCode == 0);
    const image::Image seen = image::readImage(image);
    float brightest = 0;
    for (std::uint32_t y = 0; y < 96; ++y) {
      for (std::uint32_t x = 0; x < 128; ++x) brightest = std::max(brightest, seen.at(x, y).x);
    }
    CAPTURE(integrator);
    CHECK(brightest > 0.3f);
    CHECK(seen.at(0, 0) == glm::vec3(0));
  }
}

TEST_CASE("an orthographic view is drawn from far away, and shows the same part of the plane through the target") {
  // A triangle at z = 0 in front of a camera at z = 5 whose view is 3 high.
  const scene::Scene drawn = boxesOf(R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
    "nodes": [{"mesh": 0}, {"camera": 0, "translation": [0.5, 0.25, 5]}],
    "cameras": [{"type": "orthographic", "orthographic": {"xmag": 1, "ymag": 1.5, "zfar": 10, "znear": 0.1}}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"byteLength": 36, "uri":
    "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})");
  const scene::Camera& camera = *drawn.camera;
  const glm::dvec3 towards = glm::dvec3(camera.from) - glm::dvec3(camera.at);
  CHECK(camera.at.x == 0.5f);
  CHECK(camera.at.y == 0.25f);
  CHECK(normalize(towards).z == Approx(1));
  CHECK(camera.angle <= 1);
  CHECK(2 * length(towards) * std::tan(glm::radians(double{camera.angle}) / 2) == Approx(3));
  CHECK(drawn.cones.size() >= 8);
}

TEST_CASE("without -o the boxes go to stdout, and their number to stderr") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.nff", row());
  const ProgramResult result = runCandela({"boxes", scene, "--depth", "1"});
  CHECK(result.exitCode == 0);
  CHECK(contains(result.err, "a.nff: 2 of "));
  CHECK(scene::parseScene(result.out, "boxes", ".").scene.cones.size() == 24);
  CHECK(runCandela({"boxes", scene, "--depth", "1", "-q"}).err.empty());
  CHECK(folder.fileCount() == 1);
}

TEST_CASE("a missing scene, view or writable file is an error of `boxes` that leaves no file") {
  const TemporaryFolder folder;
  CHECK(runCandela({"boxes"}).exitCode == 1);
  CHECK(runCandela({"boxes", "a.nff", "--depth", "x"}).exitCode == 1);
  CHECK(runCandela({"boxes", folder.path("none.nff"), "-o", folder.path("b.nff")}).exitCode == 2);
  const std::string noView = folder.write("a.nff", "s 0 0 0 1\n");
  const ProgramResult viewless = runCandela({"boxes", noView, "-o", folder.path("b.nff")});
  CHECK(viewless.exitCode == 2);
  CHECK(contains(viewless.err, "view"));
  CHECK(runCandela({"boxes", folder.write("c.nff", row()), "-o", folder.path("none/b.nff")}).exitCode == 2);
  CHECK(folder.fileCount() == 2);
}

}  // namespace candela

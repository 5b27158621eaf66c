// Views that are turned about their targets.
#include "host/formats/orbit.h"

#include <catch2/catch.hpp>

#include "host/formats/load_scene.h"
#include "tests/base/temporary_folder.h"

namespace candela::formats {
namespace {

/// A ball of radius 1 at (3, 1, 0), seen from +z, or with z up from -y.
std::string ball(bool isZUp) {
  const std::string view = isZUp ? "from 3 -5 1\nat 3 0 1\nup 0 0 1\n" : "from 3 1 5\nat 3 1 0\nup 0 1 0\n";
  return "v\n" + view + "angle 40\nhither 1\nresolution 8 6\nf 1 1 1 1 0 0 0 1\n" +
         (isZUp ? "s 3 0 1 1\n" : "s 3 1 0 1\n");
}

void checkNear(const glm::vec3& a, const glm::vec3& b) { CHECK(glm::distance(a, b) < 1e-6f); }

}  // namespace

TEST_CASE("a camera is turned counterclockwise about its target, seen from above") {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.p3f", ball(false));
  const scene::Camera camera = *loadScene(file, {.orbit = 90}).scene.camera;
  checkNear(camera.from, {8, 1, 0});
  checkNear(camera.at, {3, 1, 0});
  checkNear(camera.up, {0, 1, 0});
  const std::string high = folder.write("b.p3f", ball(true));
  checkNear(loadScene(high, {.orbit = 90}).scene.camera->from, {8, 0, 1});
}

TEST_CASE("an orbit leaves everything but the camera in place, and changes the hash of the scene") {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.p3f", ball(false));
  const scene::Scene front = loadScene(file).scene, side = loadScene(file, {.orbit = 30}).scene;
  CHECK(front.hash != side.hash);
  CHECK(front.hash == loadScene(file, {.orbit = 0}).scene.hash);
  CHECK(front.spheres == side.spheres);
  CHECK(front.up == side.up);
}

TEST_CASE("a tilted camera keeps its height and turns its upper side along") {
  scene::Scene scene;
  scene::Camera& camera = scene.camera.emplace();
  camera.from = {2, 4, 5};
  camera.at = {2, 1, 0};
  camera.up = {0.6f, 0.8f, 0};
  const scene::Camera turned = orbitedCamera(scene, 180);
  checkNear(turned.from, {2, 4, -5});
  checkNear(turned.at, {2, 1, 0});
  checkNear(turned.up, {-0.6f, 0.8f, 0});
}

TEST_CASE("a file that is read once gives the scenes of single readings") {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.p3f", ball(false));
  SceneSource source(file, {.environment = {"white"}});
  for (const double orbit : {0.0, 45.0, 0.0}) {
    const scene::Scene often = source.at({}, orbit).scene;
    const scene::Scene once = loadScene(file, {.orbit = orbit, .environment = {"white"}}).scene;
    CHECK(often.hash == once.hash);
    CHECK(often.camera == once.camera);
    CHECK(often.environment == once.environment);
  }
}

}  // namespace candela::formats

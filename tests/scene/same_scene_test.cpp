// Comparison of scenes: each member but the camera, the name and the hash makes a difference.
#include "host/scene/same_scene.h"

#include <catch2/catch.hpp>
#include <functional>

namespace candela::scene {
namespace {

Scene smallScene() {
  Scene scene;
  scene.camera.emplace();
  scene.materials.resize(1);
  scene.spheres.push_back({{0, 0, 0}, 1});
  scene.primitives.push_back({PrimitiveKind::sphere, 0, 0});
  scene.meshes.push_back({.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
  scene.images.push_back({"image", 1, 1, {7}});
  scene.pointLights.push_back({{0, 9, 0}});
  scene.environment.emplace().texels = {{1, 1, 1}};
  return scene;
}

}  // namespace

TEST_CASE("scenes with other cameras, names and hashes have the same content") {
  Scene other = smallScene();
  other.camera->from.x = 5;
  other.name = "other";
  other.hash = 3;
  CHECK(differOnlyInCamera(smallScene(), other));
  other.camera.reset();
  CHECK(differOnlyInCamera(smallScene(), other));
}

TEST_CASE("a change of anything else is a difference") {
  const std::vector<std::function<void(Scene&)>> changes{
      [](Scene& scene) { scene.background.x = 1; },
      [](Scene& scene) { scene.sky.emplace(); },
      [](Scene& scene) { scene.environment->texels[0].y = 2; },
      [](Scene& scene) {
        scene.up = {0, 0, 1};
      },
      [](Scene& scene) { scene.materials[0].emission.z = 1; },
      [](Scene& scene) { scene.images[0].texels[0] = 8; },
      [](Scene& scene) {
        scene.primitives = {{PrimitiveKind::sphere, 0, 1}};
      },
      [](Scene& scene) { scene.spheres[0].radius = 2; },
      [](Scene& scene) { scene.meshes[0].positions[2].y = 2; },
      [](Scene& scene) { scene.meshes[0].colours.resize(3); },
      [](Scene& scene) {
        scene.boxes.push_back({{0, 0, 0}, {1, 1, 1}});
      },
      [](Scene& scene) { scene.cones.emplace_back(); },
      [](Scene& scene) { scene.planes.emplace_back(); },
      [](Scene& scene) { scene.objectStarts.push_back(0); },
      [](Scene& scene) { scene.objectNames.emplace_back("ball"); },
      [](Scene& scene) { scene.materialNames.emplace_back("red"); },
      [](Scene& scene) { scene.pointLights[0].position.x = 1; },
      [](Scene& scene) { scene.punctualLights.emplace_back(); },
      [](Scene& scene) { scene.requestedAccel = RequestedAccel::grid; },
      [](Scene& scene) { scene.requestedSamples = 4; },
      [](Scene& scene) { scene.requestedMaxDepth = 4; },
      [](Scene& scene) {
        scene.requestedCrop = Window{1, 2, 3, 4};
      },
      [](Scene& scene) { scene.requestedFilter = PixelFilter{FilterKind::tent}; },
      [](Scene& scene) { scene.exactMean.emplace(); }};
  for (std::size_t i = 0; i < changes.size(); ++i) {
    INFO("change " << i);
    Scene other = smallScene();
    changes[i](other);
    CHECK_FALSE(differOnlyInCamera(smallScene(), other));
  }
}

}  // namespace candela::scene

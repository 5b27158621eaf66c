// Cameras that are moved, and their text.
#include "host/app/view/camera_control.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "host/app/view/camera_text.h"
#include "host/formats/load_scene.h"

using namespace candela;
using view::CameraControl;

namespace {

constexpr double kQuarter = std::numbers::pi / 2;

// At (0, 0, 4), looking at the origin along -Z, with a view plane of height 8 through the origin.
scene::Camera cameraOnAxis() {
  scene::Camera camera;
  camera.from = {0, 0, 4};
  camera.angle = 90;
  return camera;
}

void requireNear(const glm::vec3& actual, const glm::vec3& expected) {
  CAPTURE(actual.x, actual.y, actual.z, expected.x, expected.y, expected.z);
  CHECK(glm::distance(actual, expected) < 1e-5f);
}

}  // namespace

TEST_CASE("orbits turn the camera about its target") {
  CameraControl control(cameraOnAxis());
  control.orbit({kQuarter, 0});
  requireNear(control.camera().from, {-4, 0, 0});
  requireNear(control.camera().at, {0, 0, 0});
  control.orbit({0, kQuarter / 2});
  requireNear(control.camera().from, {-std::sqrt(8.0f), std::sqrt(8.0f), 0});
}

TEST_CASE("no turn reaches the axis that points up") {
  CameraControl control(cameraOnAxis());
  for (int i = 0; i < 10; ++i) control.orbit({0.3, 1});
  const glm::dvec3 direction = glm::normalize(glm::dvec3(control.camera().from));
  CHECK(std::acos(direction.y) == Approx(CameraControl::kMinPolarAngle).epsilon(1e-3));
  for (int i = 0; i < 10; ++i) control.look({0, 1});
  const glm::dvec3 view = glm::normalize(glm::dvec3(control.camera().at - control.camera().from));
  CHECK(std::acos(view.y) == Approx(CameraControl::kMinPolarAngle).epsilon(1e-3));
}

TEST_CASE("a look turns the view about the camera") {
  CameraControl control(cameraOnAxis());
  control.look({kQuarter, 0});
  requireNear(control.camera().from, {0, 0, 4});
  requireNear(control.camera().at, {4, 0, 4});
}

TEST_CASE("pans and flights move camera and target equally, and a dolly changes the distance") {
  CameraControl control(cameraOnAxis());
  control.pan({0.5, 0.25});
  requireNear(control.camera().at, {4, 2, 0});
  requireNear(control.camera().from, {4, 2, 4});
  control.fly({0, 0, 0.5});
  requireNear(control.camera().at, {4, 2, -2});
  control.dolly(0.5);
  requireNear(control.camera().from, {4, 2, 0});
  control.reset();
  requireNear(control.camera().from, {0, 0, 4});
}

TEST_CASE("a dolly changes the height of an orthographic view") {
  scene::Camera camera = cameraOnAxis();
  camera.orthographicHeight = 3;
  CameraControl control(camera);
  control.dolly(2);
  CHECK(*control.camera().orthographicHeight == 6);
  requireNear(control.camera().from, camera.from);
  control.pan({1, 0});
  requireNear(control.camera().at, {6, 0, 0});
}

TEST_CASE("a scene file reads the text of a camera, to the bit") {
  scene::Camera camera = cameraOnAxis();
  camera.from = {0.1f, -1e-7f, 12345.678f};
  camera.at = {1.0f / 3, 2, 3};
  camera.up = {0, 0.9f, 0.1f};
  camera.angle = 33.3f;
  camera.width = 320;
  camera.height = 200;
  camera.aperture = 2.5f;
  camera.focal = 1.25f;
  camera.shift = {0.25f, -0.5f};
  camera.isMirrored = true;
  const std::string text = view::cameraText(camera) + "f 1 1 1 1 0 0 0 1\ns 0 0 0 1\n";
  const scene::Camera read = *formats::loadScene(scene::SceneFile{text, "view.nff", "."}).scene.camera;
  CHECK(read.from == camera.from);
  CHECK(read.at == camera.at);
  CHECK(read.up == camera.up);
  CHECK(read.angle == camera.angle);
  CHECK(read.width == camera.width);
  CHECK(read.height == camera.height);
  CHECK(read.aperture == camera.aperture);
  CHECK(read.focal == camera.focal);
  CHECK(text.starts_with("# shifted by 0.25 -0.5: "));
  CHECK(text.find("\n# mirrored: ") != std::string::npos);
}

// Cameras: conversion, choice, and the view that frames the model.
#include "host/formats/gltf/cameras.h"
#include "tests/formats/gltf/gltf_file.h"

namespace candela::gltf {
namespace {

json perspective(double yfov, double aspect) {
  return {{"type", "perspective"}, {"perspective", {{"yfov", yfov}, {"aspectRatio", aspect}, {"znear", 0.1}}}};
}

json orthographic(double xmag, double ymag) {
  return {{"type", "orthographic"}, {"orthographic", {{"xmag", xmag}, {"ymag", ymag}, {"znear", 0.1}, {"zfar", 9}}}};
}

/// Two cameras, "near" at node 1 and an unnamed one at the node "far eye".
GltfFile withCameras() {
  GltfFile file = triangleFile();
  file.root["cameras"] = {perspective(1, 2), perspective(0.5, 0.5)};
  file.root["cameras"][0]["name"] = "near";
  file.addNode({{"camera", 0}, {"translation", {0, 0, 4}}});
  file.addNode({{"camera", 1}, {"name", "far eye"}, {"translation", {0, 0, 9}}});
  return file;
}

scene::Camera chosen(const std::optional<std::string>& wish) {
  return *sceneOf(withCameras(), {.camera = wish}).camera;
}

void checkPoint(const glm::vec3& actual, const glm::vec3& expected) {
  CAPTURE(actual.x, actual.y, actual.z);
  CHECK(glm::distance(actual, expected) < 1e-5f);
}

}  // namespace

TEST_CASE("a camera looks along -z of its node, and yfov is the vertical field of view") {
  const scene::Camera camera = chosen("near");
  checkPoint(camera.from, {0, 0, 4});
  checkPoint(camera.at, {0, 0, 0});  // as far as the centre of the model
  checkPoint(camera.up, {0, 1, 0});
  CHECK(camera.angle == Approx(180 / std::numbers::pi));
  CHECK(camera.width == 1024);
  CHECK(camera.height == 512);
  CHECK(camera.aperture == 0);
}

TEST_CASE("a camera turns with its node, whatever the node's scale") {
  GltfFile file = withCameras();
  const double a = std::sqrt(0.5);
  file.root["nodes"][1].update({{"rotation", {0, a, 0, a}}, {"scale", {3, 3, 3}}, {"translation", {4, 0, 0}}});
  const scene::Camera camera = *sceneOf(file).camera;
  checkPoint(glm::normalize(camera.at - camera.from), {-1, 0, 0});
  checkPoint(camera.up, {0, 1, 0});
}

TEST_CASE("cameras are chosen by name of camera or node, by index, and the first by default") {
  CHECK(chosen(std::nullopt).from.z == 4);
  CHECK(chosen("0").from.z == 4);
  CHECK(chosen("1").from.z == 9);
  CHECK(chosen("far eye").from.z == 9);
  const std::string error = errorsOf(withCameras().text(), {.camera = "nera"});
  CHECK(error.find("no camera \"nera\"; the scene's cameras are 0 \"near\", 1 \"far eye\"") != std::string::npos);
  CHECK(errorsOf(triangleFile().text(), {.camera = "0"}).find("the scene has no camera") != std::string::npos);
}

TEST_CASE("without a camera, the view shows the sphere around the model from the front") {
  const scene::Camera camera = *sceneOf(triangleFile()).camera;
  checkPoint(camera.at, {0.5f, 0.5f, 0});
  const glm::vec3 back = camera.from - camera.at;
  const double radius = std::sqrt(0.5);
  CHECK(std::sin(15 * std::numbers::pi / 180) * glm::length(back) == Approx(1.05 * radius));
  CHECK(back.x == Approx(0).margin(1e-6));
  CHECK(back.y / glm::length(back) == Approx(std::sin(15 * std::numbers::pi / 180)));
  CHECK(chosen("none").angle == 30);
}

TEST_CASE("the view is stated") {
  const scene::LoadedScene loaded = load(withCameras());
  CHECK(loaded.facts.at(0) == std::pair<std::string, std::string>("view", "camera 0 \"near\" of the file"));
  CHECK(load(triangleFile()).facts.at(0).second == "a view that frames the model");
}

TEST_CASE("an orthographic camera shows twice its ymag vertically, and xmag decides the default width") {
  GltfFile file = withCameras();
  file.root["cameras"][0] = orthographic(3, 1.5);
  const scene::LoadedScene loaded = load(file);
  CHECK(loaded.facts.at(0).second == "camera 0 of the file");
  const scene::Camera camera = *loaded.scene.camera;
  CHECK(camera.orthographicHeight == 3.0f);
  CHECK(camera.width == 1024);
  CHECK(camera.height == 512);
  checkPoint(camera.from, {0, 0, 4});
  checkPoint(camera.at, {0, 0, 0});
  checkPoint(camera.up, {0, 1, 0});
  CHECK(chosen("far eye").orthographicHeight == std::nullopt);
}

TEST_CASE("orthographic cameras are chosen as others are, and turn with their node whatever its scale") {
  GltfFile file = withCameras();
  file.root["cameras"][1] = orthographic(-1, -2);  // the sign has no effect
  const double a = std::sqrt(0.5);
  file.root["nodes"][2].update({{"rotation", {0, a, 0, a}}, {"scale", {3, 3, 3}}});
  for (const char* wish : {"1", "far eye"}) {
    const scene::Camera camera = *sceneOf(file, {.camera = wish}).camera;
    CHECK(camera.orthographicHeight == 4.0f);
    CHECK(camera.width == 256);
    checkPoint(glm::normalize(camera.at - camera.from), {-1, 0, 0});
  }
  CHECK(sceneOf(file).camera->orthographicHeight == std::nullopt);
}

TEST_CASE("a camera of the file that shows less than 1 percent of the model causes a warning") {
  // The radius of the sphere around the triangle is sqrt(1/2), its centre is (1/2, 1/2, 0).
  const auto warnsAt = [](const json& lens, double x, double z, const std::optional<std::string>& wish = std::nullopt) {
    GltfFile file = triangleFile();
    file.root["cameras"] = json::array({lens});
    file.addNode({{"camera", 0}, {"translation", {x, 0.5, z}}});
    return warns(load(file, {.camera = wish}), "camera 0 of the file shows the model in less than 1 % of the picture");
  };
  // Half a unit of height at distance 1: the sphere covers pi / 2 / (z * z) / 2 of the picture.
  const json wide = perspective(2 * std::atan(0.5), 2);
  CHECK_FALSE(warnsAt(wide, 0.5, 8.8));
  CHECK(warnsAt(wide, 0.5, 8.9));
  CHECK_FALSE(warnsAt(wide, 0.5, 8.9, "0"));
  CHECK_FALSE(warnsAt(wide, 0.5, 0.5));
  CHECK_FALSE(warnsAt(wide, 0.5, -0.8, "none"));
  CHECK(warnsAt(wide, 0.5, -0.8));     // behind the camera
  CHECK_FALSE(warnsAt(wide, 2.1, 1));  // one unit on each side
  CHECK(warnsAt(wide, 2.3, 1));
  CHECK_FALSE(warnsAt(orthographic(6, 6), 0.5, 100));
  CHECK(warnsAt(orthographic(6.5, 6.5), 0.5, 100));
}

TEST_CASE("a model that is too far from the origin for single precision causes a warning, and is otherwise read") {
  // The triangle's diagonal is sqrt 2. From 2048 on, single precision has steps of 1/4096.
  const auto loadedAt = [](double x) {
    GltfFile file = triangleFile();
    file.root["nodes"][0]["translation"] = {x, 0, 0};
    return load(file);
  };
  CHECK_FALSE(warns(loadedAt(0), "far from the origin"));
  CHECK_FALSE(warns(loadedAt(-4000), "far from the origin"));
  CHECK(warns(loadedAt(-5000), "resolves only 1/2896 of its size (0.00049 units at a distance of 5e+03)"));
  CHECK(warns(loadedAt(1e6), "resolves only 1/23 of its size (0.062 units at a distance of 1e+06)"));
}

TEST_CASE("a model that is scaled to a point causes a warning about its extent, not about the view") {
  GltfFile file = triangleFile();
  file.root["nodes"][0]["scale"] = {0, 0, 0};
  const scene::LoadedScene loaded = load(file);
  CHECK(warns(loaded, "the model has no extent: all of its vertices are at one point"));
  CHECK_FALSE(warns(loaded, "camera = none"));
}

TEST_CASE("cameras without an extent or of another type are errors") {
  const auto errorOf = [](const json& camera) {
    GltfFile file = withCameras();
    file.root["cameras"][0] = camera;
    return errorsOf(file.text());
  };
  for (const double magnification : {0.0, 1e-60, 1e39}) {
    CHECK(errorOf(orthographic(magnification, 1)).find("/cameras/0/orthographic/xmag: ") != std::string::npos);
    CHECK(errorOf(orthographic(1, magnification)).find("/cameras/0/orthographic/ymag: ") != std::string::npos);
  }
  CHECK(errorOf({{"type", "orthographic"}}).find("/cameras/0: ") != std::string::npos);
  CHECK(errorOf({{"type", "fisheye"}}).find("/cameras/0/type: expected") != std::string::npos);
}

}  // namespace candela::gltf

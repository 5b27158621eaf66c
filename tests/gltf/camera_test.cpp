// Cameras: conversion, choice, and the view that frames the model.
#include "host/gltf/cameras.h"
#include "tests/gltf/gltf_file.h"

namespace candela::gltf {
namespace {

json perspective(double yfov, double aspect) {
  return {{"type", "perspective"}, {"perspective", {{"yfov", yfov}, {"aspectRatio", aspect}, {"znear", 0.1}}}};
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

TEST_CASE("orthographic cameras are skipped, and refused by name") {
  GltfFile file = withCameras();
  file.root["cameras"][0]["type"] = "orthographic";
  const scene::LoadedScene second = load(file);
  CHECK(second.facts.at(0).second == "camera 1 of the file");
  CHECK_FALSE(warns(second, "orthographic"));
  CHECK(errorsOf(file.text(), {.camera = "near"}).find("/cameras/0/type: only perspective cameras") !=
        std::string::npos);
}

TEST_CASE("a file whose cameras are all orthographic is framed, with a warning") {
  GltfFile file = withCameras();
  for (json& camera : file.root["cameras"]) camera["type"] = "orthographic";
  const scene::LoadedScene framed = load(file);
  CHECK(framed.facts.at(0).second == "a view that frames the model");
  CHECK(framed.scene.camera->angle == 30);
  CHECK(warns(framed, "orthographic cameras are not supported"));
  CHECK_FALSE(warns(load(file, {.camera = "none"}), "orthographic"));
  CHECK(errorsOf(file.text(), {.camera = "1"}).find("/cameras/1/type: only perspective cameras") != std::string::npos);
}

}  // namespace candela::gltf

// Point lights with fall-off, spot lights and directional lights, together with every other kind of light: the device
// chooses and evaluates them like the reference.
#include <catch2/catch.hpp>

#include "tests/trace/reference/scene_builder.h"
#include "tests/trace/render/pixel_agreement.h"

using namespace candela;
using namespace candela::device;
using glm::vec3;
using test::diffuseMaterial;
using test::SceneBuilder;

namespace {

using Kind = scene::PunctualLight::Kind;

// Two of each kind that has a position, in an order that does not sort them by kind; a light that shines away from
// everything, and one that is switched off. Each colour differs, so that exchanged lights are detected.
std::vector<scene::PunctualLight> punctualLights() {
  return {{.kind = Kind::spot,
           .position = {-2, -1, 3},
           .direction = {0.6f, 0, -0.8f},
           .intensity = {20, 4, 1},
           .versineInner = 0.05f,
           .versineOuter = 0.2f},
          {.kind = Kind::directional, .direction = {0, 0.6f, -0.8f}, .intensity = {0.5f, 0.75f, 2}, .reach = 2.5f},
          {.kind = Kind::point, .position = {2.5f, -1, 1.5f}, .intensity = {1, 6, 3}},
          {.kind = Kind::point, .position = {0, 0, 9}, .intensity = {0, 0, 0}},
          {.kind = Kind::spot,
           .position = {1, -4, 2},
           .direction = {-0.28f, 0.96f, 0},
           .intensity = {2, 9, 30},
           .versineInner = 0.04f,
           .versineOuter = 0.0401f},
          {.kind = Kind::spot, .position = {0, 0, 5}, .direction = {0, 0, 1}, .intensity = {5, 5, 5}},
          {.kind = Kind::point, .position = {-1.5f, 1.5f, 0.25f}, .intensity = {3, 0.5f, 0.25f}}};
}

// A floor, a wall, a ball with a highlight and a box, which shade each other.
SceneBuilder objects() {
  SceneBuilder b;
  b.material(diffuseMaterial(vec3(0.7f))).plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  b.material(diffuseMaterial({0.6f, 0.7f, 0.8f})).quad({-4, 3, 0}, {4, 3, 0}, {4, 3, 4}, {-4, 3, 4});
  b.material(test::mixtureMaterial(0.5f, 0.4f, 30)).sphere({-0.5f, 0.5f, 0.75f}, 0.75f);
  b.material(diffuseMaterial({0.8f, 0.7f, 0.5f})).box({0.75f, 0, 0}, {1.75f, 1, 1.25f});
  b.view({0, -7, 4}, {0, 0, 0.75f}, {0, 0, 1}, 40);
  b.scene.name = "punctual lights";
  return b;
}

scene::Scene underPunctualLights() {
  SceneBuilder b = objects();
  b.scene.punctualLights = punctualLights();
  return b.scene;
}

// Also under a ball and a triangle that emit, a point light without fall-off, and a background.
scene::Scene underAllLights() {
  SceneBuilder b = objects();
  b.material(diffuseMaterial(vec3(0.5f), {6, 3, 1})).sphere({-2.5f, -1, 0.5f}, 0.25f);
  b.material(diffuseMaterial(vec3(0), {1, 4, 2})).triangle({-1, 1, 3.5f}, {0, 2, 3.5f}, {1, 1, 3.25f});
  b.pointLight({3, -3, 4}, {0.1f, 0.2f, 0.3f});
  b.scene.background = vec3(0.05f);
  b.scene.punctualLights = punctualLights();
  return b.scene;
}

void requireSamePixels(const scene::Scene& scene, std::uint32_t seed, bool nextEventEstimation) {
  render::RenderSettings settings = squareSettings(96, 1);
  settings.image.seed = seed;
  settings.image.nextEventEstimation = nextEventEstimation;
  checkPixelsAgree(scene, settings);
}

}  // namespace

TEST_CASE("point, spot and directional lights have the reference's pixels at equal seeds") {
  const scene::Scene scene = underPunctualLights();
  for (const std::uint32_t seed : {0u, 1u, 2u, 3u}) requireSamePixels(scene, seed, true);
}

TEST_CASE("punctual lights among all other kinds of light have the reference's pixels at equal seeds",
          "[swiftshader-slow]") {
  const scene::Scene scene = underAllLights();
  for (const bool nextEventEstimation : {true, false}) {
    for (const std::uint32_t seed : {0u, 1u, 2u}) requireSamePixels(scene, seed, nextEventEstimation);
  }
}

TEST_CASE("punctual lights among all other kinds of light have the reference's mean", "[swiftshader-slow]") {
  const scene::Scene scene = underAllLights();
  const render::RenderSettings settings = squareSettings(64, 64);
  const double device = meanLuminance(renderOnDevice(scene, settings).film);
  CHECK(device == Approx(meanLuminance(renderOnReference(scene, settings).film)).epsilon(kMeanTolerance));
}

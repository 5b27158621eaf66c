// Environments among all other kinds of light: the device's pixels are the reference's.
#include <catch2/catch.hpp>
#include <random>

#include "host/scene/environment/placement.h"
#include "host/scene/environment/weights.h"
#include "tests/trace/reference/scene_builder.h"
#include "tests/trace/render/pixel_agreement.h"

using namespace candela;
using namespace candela::device;
using glm::vec3;
using test::diffuseMaterial;
using test::SceneBuilder;

namespace {

scene::Environment environmentOfNoise(std::uint32_t width, std::uint32_t height, const vec3& up, bool hasRowsAtPoles) {
  std::mt19937 random(7);
  scene::Environment map{.name = "noise", .width = width, .height = height, .texels = {}, .weights = {}};
  for (std::uint32_t i = 0; i < width * height; ++i) {
    const auto channel = [&] { return static_cast<float>(random() % 1000) / 1000; };
    const float bright = random() % 50 == 0 ? 20.0f : 0.5f;
    map.texels.push_back(bright * vec3(channel(), channel(), channel()));
  }
  map.hasRowsAtPoles = hasRowsAtPoles;
  environment::setWeights(map);
  environment::place(map, up, 77);
  return map;
}

SceneBuilder objectsInEnvironment(bool hasRowsAtPoles = false) {
  SceneBuilder b;
  b.material(diffuseMaterial(vec3(0.7f))).plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  b.material(test::mixtureMaterial(0.5f, 0.4f, 30)).sphere({-0.5f, 0.5f, 0.75f}, 0.75f);
  b.material(test::mirrorMaterial(vec3(0.9f))).sphere({0.8f, -1, 0.4f}, 0.4f);
  b.material(diffuseMaterial({0.8f, 0.7f, 0.5f})).box({0.75f, 0, 0}, {1.75f, 1, 1.25f});
  b.view({0, -7, 4}, {0, 0, 0.75f}, {0, 0, 1}, 40);
  b.scene.name = "environment";
  b.scene.environment = environmentOfNoise(37, 19, {0, 0, 1}, hasRowsAtPoles);
  return b;
}

void addLightsBesideEnvironment(SceneBuilder& b) {
  b.material(diffuseMaterial(vec3(0.5f), {6, 3, 1})).sphere({-2.5f, -1, 0.5f}, 0.25f);
  b.material(diffuseMaterial(vec3(0), {1, 4, 2})).triangle({-1, 1, 3.5f}, {0, 2, 3.5f}, {1, 1, 3.25f});
  b.pointLight({3, -3, 4}, {0.1f, 0.2f, 0.3f});
  b.scene.punctualLights = {{.position = {2.5f, -1, 1.5f}, .intensity = {1, 6, 3}}};
}

}  // namespace

TEST_CASE("an environment has the reference's pixels at equal seeds, alone and among all other kinds of light",
          "[swiftshader-slow]") {
  SceneBuilder b = objectsInEnvironment(GENERATE(false, true));
  for (const bool others : {false, true}) {
    if (others) addLightsBesideEnvironment(b);
    for (const bool nextEventEstimation : {true, false}) {
      render::RenderSettings settings = squareSettings(96, 1);
      settings.image.nextEventEstimation = nextEventEstimation;
      settings.image.seed = others ? 1 : 2;
      checkPixelsAgree(b.scene, settings, 0.5);
    }
  }
}

TEST_CASE("an environment has the reference's pixels with every sampler", "[swiftshader-slow]") {
  for (const auto sampler :
       {render::SamplerKind::independent, render::SamplerKind::stratified, render::SamplerKind::sobol}) {
    render::RenderSettings settings = squareSettings(64, 4);
    settings.image.sampler = sampler;
    const scene::Scene scene = objectsInEnvironment().scene;
    const double device = meanLuminance(renderOnDevice(scene, settings).film);
    CHECK(device == Approx(meanLuminance(renderOnReference(scene, settings).film)).epsilon(2e-4));
  }
}

TEST_CASE("limited indirect light has the reference's pixels, and is not brighter than unlimited light",
          "[swiftshader-slow]") {
  SceneBuilder b = objectsInEnvironment();
  addLightsBesideEnvironment(b);
  render::RenderSettings settings = squareSettings(96, 1);
  const double unlimited = meanLuminance(renderOnDevice(b.scene, settings).film);
  settings.image.indirectLimit = 0.25f;
  checkPixelsAgree(b.scene, settings, 0.5);
  const double limited = meanLuminance(renderOnDevice(b.scene, settings).film);
  CHECK(limited < 0.99 * unlimited);
  settings.image.maxDepth = 2;  // light that was scattered once has no limit
  const double direct = meanLuminance(renderOnDevice(b.scene, settings).film);
  settings.image.indirectLimit = std::nullopt;
  // Two kernels: a compiler may contract other products and sums in each of them.
  CHECK(direct == Approx(meanLuminance(renderOnDevice(b.scene, settings).film)).epsilon(1e-8));
}

TEST_CASE("environments give the same film by every kernel and every type of load", "[swiftshader-slow]") {
  const scene::Scene scene = objectsInEnvironment().scene;
  render::RenderSettings settings = squareSettings(48, 4);
  const auto hash = renderOnDevice(scene, settings).film.hash();
  settings.execution.sceneLoads = render::SceneLoads::storage;
  CHECK(renderOnDevice(scene, settings).film.hash() == hash);
  settings.execution.kernel = render::KernelKind::wavefront;
  CHECK(renderOnDevice(scene, settings).film.hash() == hash);
}

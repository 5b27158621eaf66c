// Volumes that absorb: the same pixels on both tracers at equal seeds, closed forms of the light that is left of a path
// and of a light sample, and paths that are stored within a volume.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/trace/reference/scene_builder.h"
#include "tests/trace/render/both_tracers.h"
#include "tests/trace/render/pixel_agreement.h"

using namespace candela;
using namespace candela::device;
using glm::vec3;
using test::diffuseMaterial;
using test::SceneBuilder;

namespace {

scene::Material glass(float roughness, const vec3& absorption, bool isThinWalled = false) {
  scene::Material material;
  material.surface = scene::SurfaceParameters{
      .roughness = roughness, .transmissionWeight = 1, .isThinWalled = isThinWalled, .absorption = absorption};
  return material;
}

// A ball and a tank of rough glass, a thin wall and a lamp on a floor; in the tank are another lamp and a diffuse ball.
scene::Scene aquarium() {
  SceneBuilder b;
  b.material(diffuseMaterial(vec3(0.7f))).plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  b.material(glass(0.4f, {0.2f, 0.8f, 2})).sphere({-1.6f, -0.5f, 0.8f}, 0.7f);
  b.material(glass(0.3f, {1.5f, 0.5f, 0.1f})).box({-0.6f, -0.5f, 0.1f}, {1.4f, 0.9f, 1.5f});
  b.material(diffuseMaterial({0.8f, 0.7f, 0.6f})).sphere({0, 0.2f, 0.6f}, 0.3f);
  b.material(diffuseMaterial(vec3(0), {6, 5, 4})).sphere({0.9f, 0.2f, 1}, 0.2f);
  b.material(glass(0.5f, vec3(9), true)).quad({1.6f, -1, 0}, {2.6f, -0.6f, 0}, {2.6f, -0.6f, 1.8f}, {1.6f, -1, 1.8f});
  b.material(diffuseMaterial(vec3(0), vec3(5))).sphere({-0.5f, -1, 3}, 0.3f);
  b.pointLight({2, -3, 3}, vec3(0.5f));
  b.scene.background = vec3(0.2f);
  b.view({0, -6, 2}, {0, 0, 0.8f}, {0, 0, 1}, 40);
  b.scene.name = "aquarium";
  return b.scene;
}

// How much less light the camera sees if the glass of the first material absorbs. Random numbers are equal, and each
// path that carries light is absorbed along the same length.
double attenuation(const RenderFunction& render, SceneBuilder b, std::uint32_t maxDepth) {
  render::RenderSettings settings = squareSettings(8, 64);
  settings.image.maxDepth = maxDepth;
  const double absorbed = meanLuminance(render(b.scene, settings).film);
  b.scene.materials[0].surface->absorption = vec3(0);
  const double clear = meanLuminance(render(b.scene, settings).film);
  REQUIRE(clear > 0);
  return absorbed / clear;
}

}  // namespace

TEST_CASE("volumes have the reference's pixels at equal seeds") {
  for (const std::uint32_t seed : {0u, 1u, 2u}) {
    render::RenderSettings settings = squareSettings(96, 1);
    settings.image.seed = seed;
    checkPixelsAgree(aquarium(), settings);
  }
}

TEST_CASE("light samples within a volume are absorbed along their own length and that of the path") {
  // Smooth glass, seen along its normal, with a diffuse floor 0.5 below its surface. The light is 0.3 above the floor
  // and 0.4 aside: the path has the length 0.5 within the glass, and the light sample 0.5 more.
  onBothTracers([](const RenderFunction& render) {
    SceneBuilder b;
    b.material(glass(0, vec3(1.25f))).box({-9, -9, -9}, {9, 9, 0});
    b.material(diffuseMaterial(vec3(1))).plane({0, 0, -0.5f}, {1, 0, -0.5f}, {0, 1, -0.5f});
    b.pointLight({0.4f, 0, -0.2f}, vec3(1));
    b.view({0, 0, 1}, {0, 0, 0}, {0, 1, 0}, 0.01f);
    CHECK(attenuation(render, b, 3) == Approx(std::exp(-1.25 * (0.5 + 0.5))).epsilon(2e-3));
  });
}

TEST_CASE("a light sample through a surface is absorbed by the volume behind it") {
  // The light is in rough glass, 0.48 below its surface and 0.14 aside of the point that the camera sees.
  onBothTracers([](const RenderFunction& render) {
    SceneBuilder b;
    b.material(glass(0.6f, vec3(1.5f))).box({-9, -9, -9}, {9, 9, 0});
    b.pointLight({0.14f, 0, -0.48f}, vec3(1));
    b.view({0, 0, 1}, {0, 0, 0}, {0, 1, 0}, 0.01f);
    CHECK(attenuation(render, b, 2) == Approx(std::exp(-1.5 * 0.5)).epsilon(2e-3));
  });
}

TEST_CASE("light sampling in and around volumes has the mean of paths without it", "[swiftshader-slow]") {
  onBothTracers([](const RenderFunction& render) {
    scene::Scene scene = aquarium();
    scene.pointLights.clear();
    render::RenderSettings settings = squareSettings(24, 1024);
    const double sampled = meanLuminance(render(scene, settings).film);
    settings.image.nextEventEstimation = false;
    CHECK(sampled == Approx(meanLuminance(render(scene, settings).film)).epsilon(0.02));
  });
}

TEST_CASE("thin walls bound no volume: their absorption changes no bit of the film") {
  onBothTracers([](const RenderFunction& render) {
    const auto hash = [&](const vec3& absorption) {
      SceneBuilder b;
      b.material(glass(0.2f, absorption, true)).box({-1, -1, -1}, {1, 1, 0});
      b.material(glass(0.2f, vec3(0))).sphere({1.5f, 0, 0}, 0.4f);
      b.material(diffuseMaterial(vec3(0.5f), vec3(0.5f))).plane({0, 0, -1.2f}, {1, 0, -1.2f}, {0, 1, -1.2f});
      b.pointLight({0, 0, -0.5f}, vec3(1)).view({0, -2, 3}, {0, 0, 0}, {0, 0, 1}, 40);
      return render(b.scene, squareSettings(32, 4)).film.hash();
    };
    CHECK(hash(vec3(3)) == hash(vec3(0)));
  });
}

TEST_CASE("a path that is stored within a volume stays in it") {
  const scene::Scene scene = aquarium();
  render::RenderSettings settings = squareSettings(48, 4);
  settings.execution.kernel = render::KernelKind::megakernel;
  settings.execution.segmentsPerDispatch = 1000;
  const std::uint64_t expected = renderOnDevice(scene, settings).film.hash();
  settings.execution.segmentsPerDispatch = 1;
  CHECK(renderOnDevice(scene, settings).film.hash() == expected);
  settings.execution.kernel = render::KernelKind::wavefront;
  CHECK(renderOnDevice(scene, settings).film.hash() == expected);
}

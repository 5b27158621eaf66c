// Single interfaces on both tracers: the same pixels at equal seeds.
#include <catch2/catch.hpp>

#include "tests/trace/reference/scene_builder.h"
#include "tests/trace/render/both_tracers.h"
#include "tests/trace/render/pixel_agreement.h"

using namespace candela;
using namespace candela::device;
using enum scene::Interface;

namespace {

scene::Material dielectric(scene::Interface shape, float roughness, float ior, bool isThin = false) {
  scene::Material material;
  material.surface = scene::SurfaceParameters{.baseColour = {0.9f, 0.95f, 0.8f},
                                              .specularColour = {1, 0.8f, 0.9f},
                                              .roughness = roughness,
                                              .ior = ior,
                                              .transmissionWeight = 1,
                                              .isThinWalled = isThin,
                                              .bareInterface = shape};
  return material;
}

scene::Material metal(scene::Interface shape, float roughness) {
  scene::Material material;
  material.surface = scene::SurfaceParameters{
      .baseColour = {0.9f, 0.9f, 0.7f},
      .metalness = 1,
      .roughness = roughness,
      .conductor = scene::Conductor{{0.143f, 0.375f, 1.442f}, {3.983f, 2.386f, 1.603f}},
      .bareInterface = shape};
  return material;
}

scene::Scene interfaces() {
  test::SceneBuilder b;
  b.material(test::diffuseMaterial({0.7f, 0.6f, 0.5f})).plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  b.material(metal(smooth, 0)).sphere({-3, 0, 0.7f}, 0.7f);
  b.material(metal(ggx, 0.4f)).sphere({-1.5f, 0, 0.7f}, 0.7f);
  b.material(metal(beckmann, 0.6f)).sphere({0, 0, 0.7f}, 0.7f);
  b.material(dielectric(smooth, 0, 1.5f)).sphere({1.5f, 0, 0.7f}, 0.7f);
  b.material(dielectric(smooth, 0, 0.75f)).sphere({3, 0, 0.7f}, 0.7f);
  b.material(dielectric(ggx, 0.4f, 1.5f)).sphere({-0.8f, -1.5f, 0.6f}, 0.5f);
  b.material(dielectric(beckmann, 0.5f, 1.4f)).sphere({0.8f, -1.5f, 0.6f}, 0.5f);
  b.material(dielectric(smooth, 0, 1.5f, true)).quad({-3, -2, 0.3f}, {-2, -2, 0.3f}, {-2, -2, 1.6f}, {-3, -2, 1.6f});
  b.material(test::diffuseMaterial(glm::vec3(0), {4, 4, 3})).sphere({0, -2, 4}, 0.6f);
  b.pointLight({-1, -4, 4}, glm::vec3(0.3f));
  b.scene.background = glm::vec3(0.3f);
  b.view({0, -8, 2}, {0, 0, 0.8f}, {0, 0, 1}, 40);
  b.scene.name = "interfaces";
  return b.scene;
}

}  // namespace

TEST_CASE("single interfaces have the reference's pixels at equal seeds") {
  const scene::Scene scene = interfaces();
  for (const std::uint32_t seed : {0u, 1u}) {
    render::RenderSettings settings = squareSettings(96, 1);
    settings.image.seed = seed;
    checkPixelsAgree(scene, settings);
  }
}

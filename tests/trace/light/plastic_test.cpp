// Plastic on both tracers: the same pixels at equal seeds.
#include <catch2/catch.hpp>

#include "tests/trace/reference/scene_builder.h"
#include "tests/trace/render/both_tracers.h"
#include "tests/trace/render/pixel_agreement.h"

using namespace candela;
using namespace candela::device;

namespace {

constexpr float kIor = 1.49f / 1.000277f;

scene::Material plastic(scene::Interface boundary, float roughness, const glm::vec3& base, bool isNonlinear) {
  scene::Material material;
  material.surface = scene::SurfaceParameters{.baseColour = base,
                                              .roughness = roughness,
                                              .ior = kIor,
                                              .plastic = scene::makePlastic(boundary, roughness, kIor, isNonlinear)};
  return material;
}

scene::Scene plasticBalls() {
  test::SceneBuilder b;
  b.material(test::diffuseMaterial(glm::vec3(0.7f))).plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  b.material(plastic(scene::Interface::smooth, 0, {0.1f, 0.27f, 0.36f}, false)).sphere({-2.4f, 0, 0.8f}, 0.8f);
  b.material(plastic(scene::Interface::ggx, 0.5f, {0.8f, 0.3f, 0.1f}, true)).sphere({-0.8f, 0, 0.8f}, 0.8f);
  b.material(plastic(scene::Interface::beckmann, 0.3f, {0.2f, 0.7f, 0.2f}, false)).sphere({0.8f, 0, 0.8f}, 0.8f);
  b.material(plastic(scene::Interface::beckmann, 0.7f, {0.5f, 0.5f, 0.8f}, true)).sphere({2.4f, 0, 0.8f}, 0.8f);
  b.scene.materials.back().surface->coatWeight = 0.7f;
  b.pointLight({-1, -4, 4}, glm::vec3(1));
  b.scene.background = glm::vec3(0.3f);
  b.view({0, -7, 1.5f}, {0, 0, 0.9f}, {0, 0, 1}, 40);
  b.scene.name = "plastic balls";
  return b.scene;
}

}  // namespace

TEST_CASE("plastic has the reference's pixels at equal seeds") {
  const scene::Scene scene = plasticBalls();
  for (const std::uint32_t seed : {0u, 1u}) {
    render::RenderSettings settings = squareSettings(96, 1);
    settings.image.seed = seed;
    checkPixelsAgree(scene, settings);
  }
}

// Surfaces with dispersion on both tracers and by both kernels: the same pixels at equal seeds.
#include <catch2/catch.hpp>
#include <random>

#include "tests/trace/reference/scene_builder.h"
#include "tests/trace/render/pixel_agreement.h"

using namespace candela;
using namespace candela::device;
using glm::vec3;

namespace {

scene::Material spreadingGlass(float roughness, float ior, float dispersion) {
  scene::Material material;
  material.surface = {.roughness = roughness,
                      .ior = ior,
                      .transmissionWeight = 1,
                      .transmissionDispersionScale = dispersion,
                      .isThinWalled = false,
                      .absorption = {0.1f, 0.3f, 0.2f}};
  return material;
}

test::SceneBuilder floorAndLight() {
  test::SceneBuilder b;
  b.material(test::diffuseMaterial(vec3(0.7f))).plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  b.material(test::diffuseMaterial({0.9f, 0.2f, 0.1f})).box({-4, 1.5f, 0}, {4, 1.7f, 1});
  b.material(test::diffuseMaterial(vec3(0), vec3(6))).quad({-1, -1, 4}, {-1, 1, 4}, {1, 1, 4}, {1, -1, 4});
  b.scene.background = {0.3f, 0.4f, 0.6f};
  b.view({0, -7, 1.5f}, {0, 0, 0.9f}, {0, 0, 1}, 40);
  return b;
}

scene::Scene glassBalls() {
  test::SceneBuilder b = floorAndLight();
  b.material(spreadingGlass(0, 1.5f, 3)).sphere({-2, 0, 0.6f}, 0.6f);
  b.material(spreadingGlass(0.2f, 1.8f, 1)).sphere({-0.6f, 0, 0.6f}, 0.6f);
  b.material(spreadingGlass(0.4f, 1.1f, 60)).sphere({0.8f, 0, 0.6f}, 0.6f);
  b.material(spreadingGlass(0.1f, 1.5f, 0)).box({1.6f, -0.5f, 0.1f}, {2.6f, 0.5f, 1.1f});
  b.scene.name = "balls of glass with dispersion";
  return b.scene;
}

// A slab whose texels turn its normals, below a coat, with metal; and glass below a thin film.
scene::Scene coveredGlass() {
  test::SceneBuilder b = floorAndLight();
  std::mt19937 random(21);
  b.scene.images = {{"normals", 4, 4, {}}};
  for (int i = 0; i < 16; ++i) b.scene.images[0].texels.push_back(static_cast<std::uint32_t>(random()));
  scene::Material mapped = spreadingGlass(0.3f, 1.6f, 4);
  mapped.surface->metalness = 0.2f;
  mapped.surface->coatWeight = 0.5f;
  mapped.textures[static_cast<std::size_t>(scene::TextureSlot::normal)] = scene::TextureReference{.image = 0};
  scene::Mesh slab;
  slab.positions = {{-2, 0, 0.1f}, {0, 0, 0.1f}, {0, 0.3f, 1.8f}, {-2, 0.3f, 1.8f}};
  slab.texCoords[0] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  slab.indices = {0, 1, 2, 0, 2, 3};
  slab.tangents.assign(4, glm::vec4(1, 0, 0, 1));
  b.material(mapped);
  addMesh(b.scene, slab, static_cast<std::uint32_t>(b.scene.materials.size() - 1));
  scene::Material film = spreadingGlass(0.2f, 1.5f, 2);
  film.surface->filmWeight = 1;
  b.material(film).sphere({1.2f, 0, 0.8f}, 0.7f);
  b.scene.name = "covered glass with dispersion";
  return b.scene;
}

}  // namespace

TEST_CASE("glass with dispersion has the reference's pixels at equal seeds, by both kernels", "[swiftshader-slow]") {
  render::RenderSettings settings = test::settingsOf(96, 96, 1);
  for (const auto kernel : {render::KernelKind::megakernel, render::KernelKind::wavefront}) {
    settings.execution.kernel = kernel;
    settings.image.seed += 1;
    checkPixelsAgree(glassBalls(), settings);
  }
}

TEST_CASE("glass with dispersion below coats, films and normal maps has the reference's pixels") {
  render::RenderSettings settings = test::settingsOf(96, 96, 1);
  checkPixelsAgree(coveredGlass(), settings);
}

TEST_CASE("both kernels make the same film of glass with dispersion", "[swiftshader-slow]") {
  render::RenderSettings settings = test::settingsOf(32, 32, 8);
  std::vector<std::uint64_t> hashes;
  for (const auto kernel : {render::KernelKind::megakernel, render::KernelKind::wavefront}) {
    settings.execution.kernel = kernel;
    hashes.push_back(renderOnDevice(glassBalls(), settings).film.hash());
  }
  CHECK(hashes[0] == hashes[1]);
}

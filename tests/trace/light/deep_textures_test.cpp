// Images with channels of 16 bits, on both tracers.
#include <catch2/catch.hpp>
#include <random>

#include "host/image/colour_transfer.h"
#include "host/image/image.h"
#include "host/trace/flatten/flat_scene.h"
#include "tests/trace/reference/scene_builder.h"
#include "tests/trace/render/both_tracers.h"
#include "tests/trace/render/pixel_agreement.h"

using namespace candela;
using namespace candela::device;
using glm::dvec3;
using glm::vec3;
using scene::TextureReference;
using scene::TextureSlot;
using test::SceneBuilder;

namespace {

constexpr std::uint32_t kSide = 16;

// Channels of 16 bits that those of 8 bits do not reach; all texels differ.
std::uint64_t rampChannel(std::uint32_t texel, std::uint32_t channel) { return 20011 + 101 * texel + 7777 * channel; }

scene::TextureImage ramp() {
  scene::TextureImage image{"ramp", kSide, kSide, {}};
  for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
    image.deepTexels.push_back(rampChannel(i, 0) | rampChannel(i, 1) << 16 | rampChannel(i, 2) << 32 |
                               std::uint64_t{65535} << 48);
  }
  return image;
}

scene::TextureImage randomImage(bool deep) {
  std::mt19937_64 random(3);
  scene::TextureImage image{"random", 5, 3, {}};
  for (int i = 0; i < 15; ++i) {
    if (deep) image.deepTexels.push_back(random());
    if (!deep) image.texels.push_back(static_cast<std::uint32_t>(random()));
  }
  return image;
}

// A square, seen from so far away that each of 16 x 16 pixels shows the centre of a texel of ramp().
scene::Scene squareOf(const scene::Material& material) {
  SceneBuilder b;
  scene::Mesh mesh;
  mesh.positions = {{-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}, {1, 1, 0}};
  mesh.normals.assign(4, {0, 0, 1});
  mesh.texCoords[0] = {{0, 0}, {0, 1}, {1, 1}, {1, 0}};
  mesh.tangents.assign(4, {1, 0, 0, 1});
  mesh.indices = {0, 1, 2, 0, 2, 3};
  b.scene.images = {ramp(), randomImage(true), randomImage(false)};
  b.material(material);
  addMesh(b.scene, mesh, 0);
  b.scene.background = vec3(0.5f);
  b.view({0, 0, 100}, {0, 0, 0}, {0, 1, 0}, static_cast<float>(2 * glm::degrees(std::atan(0.01))));
  return b.scene;
}

scene::Material withTexture(scene::Material material, TextureSlot slot, const TextureReference& reference) {
  material.textures[static_cast<std::size_t>(slot)] = reference;
  return material;
}

const TextureReference kNearest{.filter = scene::TextureFilter::nearest};
const TextureReference kDeepNoise{.image = 1};
const TextureReference kShallowNoise{.image = 2};

image::Image shown(const RenderFunction& render, const scene::Scene& scene, render::Integrator integrator) {
  render::RenderSettings settings = squareSettings(kSide, 1);
  settings.image.integrator = integrator;
  return image::toImage(render(scene, settings).film);
}

void requireSamePixelsAtSeeds(const scene::Scene& scene) {
  for (const std::uint32_t seed : {0u, 1u}) {
    render::RenderSettings settings = squareSettings(96, 1);
    settings.image.seed = seed;
    checkPixelsAgree(scene, settings, 0.25);
  }
}

}  // namespace

TEST_CASE("colours of 16 bits are decoded from sRGB without rounding them to 8 bits") {
  const scene::Scene scene = squareOf(withTexture(test::diffuseMaterial(vec3(1)), TextureSlot::baseColour, kNearest));
  onBothTracers([&](const RenderFunction& render) {
    const image::Image albedos = shown(render, scene, render::Integrator::albedo);
    for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
      for (std::uint32_t c = 0; c < 3; ++c) {
        const double exact = image::srgbDecode(static_cast<double>(rampChannel(i, c)) / 65535);
        CAPTURE(i, c);
        REQUIRE(albedos.at(i % kSide, i / kSide)[static_cast<int>(c)] == Approx(exact).epsilon(1e-6));
      }
    }
  });
}

TEST_CASE("normal maps of 16 bits are not rounded to 8 bits") {
  scene::Material mapped;
  mapped.surface = scene::SurfaceParameters{};
  const scene::Scene scene = squareOf(withTexture(mapped, TextureSlot::normal, kNearest));
  onBothTracers([&](const RenderFunction& render) {
    const image::Image normals = shown(render, scene, render::Integrator::normal);
    for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
      dvec3 direction;
      for (std::uint32_t c = 0; c < 3; ++c) {
        direction[static_cast<int>(c)] = 2 * static_cast<double>(rampChannel(i, c)) / 65535 - 1;
      }
      if (direction.z < 0) direction.z = -direction.z;  // mirrored at the surface
      const dvec3 exact = 0.5 * glm::normalize(direction) + 0.5;
      CAPTURE(i);
      REQUIRE(glm::length(dvec3(normals.at(i % kSide, i / kSide)) - exact) < 2e-6);
    }
  });
}

TEST_CASE("parameters from images of 8 and 16 bits have the reference's pixels at equal seeds") {
  scene::Material material;
  material.surface = scene::SurfaceParameters{.metalness = 1};
  material = withTexture(material, TextureSlot::baseColour, kDeepNoise);
  material = withTexture(material, TextureSlot::metallicRoughness, kDeepNoise);
  material = withTexture(material, TextureSlot::glossiness, kDeepNoise);
  material = withTexture(material, TextureSlot::specularColour, kShallowNoise);
  requireSamePixelsAtSeeds(squareOf(material));
}

TEST_CASE("emission and opacity of 16 bits have the reference's pixels at equal seeds") {
  scene::Material material = withTexture(test::diffuseMaterial(vec3(0.5f), {3, 2, 4}), TextureSlot::emission,
                                         kDeepNoise);
  material.opacity = scene::Opacity{.texture = kDeepNoise};
  SECTION("blended") {}
  SECTION("masked") { material.opacity->cutoff = 0.4f; }
  scene::Scene scene = squareOf(material);
  scene.materials.push_back(test::diffuseMaterial(vec3(0.7f)));
  addMesh(scene, scene::Mesh{.positions = {{-4, -4, -1}, {4, -4, -1}, {0, 6, -1}}, .indices = {0, 1, 2}}, 1);
  requireSamePixelsAtSeeds(scene);
}

TEST_CASE("scenes without images of 16 bits have no code for them") {
  scene::Scene scene = squareOf(withTexture(test::diffuseMaterial(vec3(1)), TextureSlot::baseColour, kShallowNoise));
  CHECK(flatten::flattenScene(scene, squareSettings(kSide, 1)).shape.features.deepTexels);
  scene.images[0] = scene.images[1] = scene.images[2];
  CHECK_FALSE(flatten::flattenScene(scene, squareSettings(kSide, 1)).shape.features.deepTexels);
}

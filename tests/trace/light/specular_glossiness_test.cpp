// Surfaces described by specular colour and glossiness, on both tracers.
#include <catch2/catch.hpp>

#include "host/image/image.h"
#include "tests/trace/reference/scene_builder.h"
#include "tests/trace/render/both_tracers.h"
#include "tests/trace/render/pixel_agreement.h"

using namespace candela;
using namespace candela::device;
using glm::vec3;
using scene::SurfaceParameters;
using scene::TextureSlot;
using test::SceneBuilder;

namespace {

// A triangle that fills the view from its front, lit at an angle. Its texture coordinates run from 0 to 1.
scene::Scene litTriangle(const scene::Material& material) {
  SceneBuilder b;
  scene::Mesh mesh;
  mesh.positions = {{-4, -4, 0}, {4, -4, 0}, {0, 6, 0}};
  mesh.normals = {{-0.3f, -0.2f, 0.9f}, {0.3f, -0.2f, 0.9f}, {0, 0.3f, 0.9f}};
  mesh.texCoords[0] = {{0, 0}, {1, 0}, {0.5f, 1}};
  mesh.indices = {0, 1, 2};
  b.scene.images = {{"", 3, 2, {0x33ff0000u, 0xff204060u, 0x80ffffffu, 0x00c0c0c0u, 0xffffffffu, 0xc0808080u}},
                    {"", 1, 1, {0x33ffffffu}}};
  b.material(material);
  addMesh(b.scene, mesh, 0);
  b.pointLight({2, 1, 4}, vec3(1));
  b.scene.background = vec3(0.4f);
  b.view({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 40);
  return b.scene;
}

scene::Material surfaceOf(const SurfaceParameters& parameters) {
  scene::Material material;
  material.surface = parameters;
  return material;
}

void setTexture(scene::Material& material, TextureSlot slot, std::uint32_t image) {
  material.textures[static_cast<std::size_t>(slot)] = scene::TextureReference{.image = image};
}

// Requires that all pixels of two scenes are equal except for rounding.
void requireEqualPixels(const RenderFunction& render, const scene::Scene& a, const scene::Scene& b) {
  const render::RenderSettings settings = squareSettings(24, 4);
  const image::Image first = image::toImage(render(a, settings).film);
  const image::Image second = image::toImage(render(b, settings).film);
  for (std::uint32_t i = 0; i < 24 * 24; ++i) {
    const glm::dvec3 value = first.at(i % 24, i / 24);
    CAPTURE(i % 24, i / 24, value.x);
    REQUIRE(value.x > 0);
    REQUIRE(glm::length(value - glm::dvec3(second.at(i % 24, i / 24))) <= 1e-4 * glm::length(value));
  }
}

const SurfaceParameters kGlossy{.baseColour = {0.3f, 0.2f, 0.1f}, .specularColour = {0.9f, 0.6f, 0.2f}, .ior = 0};

}  // namespace

TEST_CASE("a dielectric with the index 0 and without a diffuse colour is the metal of its specular colour") {
  SurfaceParameters glossy = kGlossy;
  glossy.baseColour = vec3(0);
  onBothTracers([&](const RenderFunction& render) {
    for (const float roughness : {0.1f, 0.5f, 1.0f}) {
      glossy.roughness = roughness;
      const SurfaceParameters metal{.baseColour = glossy.specularColour, .metalness = 1, .roughness = roughness};
      requireEqualPixels(render, litTriangle(surfaceOf(glossy)), litTriangle(surfaceOf(metal)));
    }
  });
}

TEST_CASE("a texture of glossiness multiplies 1 - roughness by alpha") {
  SurfaceParameters glossy = kGlossy;
  glossy.roughness = 0.25f;
  scene::Material textured = surfaceOf(glossy);
  setTexture(textured, TextureSlot::glossiness, 1);  // an alpha of 0.2
  glossy.roughness = 0.85f;
  onBothTracers([&](const RenderFunction& render) {
    requireEqualPixels(render, litTriangle(textured), litTriangle(surfaceOf(glossy)));
  });
}

TEST_CASE("textures of specular colour and glossiness have the reference's pixels at equal seeds") {
  scene::Material material = surfaceOf(kGlossy);
  material.surface->roughness = 0.1f;
  setTexture(material, TextureSlot::baseColour, 0);
  setTexture(material, TextureSlot::specularColour, 0);
  setTexture(material, TextureSlot::glossiness, 0);
  for (const std::uint32_t seed : {0u, 1u, 2u}) {
    render::RenderSettings settings = squareSettings(96, 1);
    settings.image.seed = seed;
    checkPixelsAgree(litTriangle(material), settings, 0.25);
  }
}

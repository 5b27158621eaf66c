// Textures on both tracers: the same pixels at equal seeds, and the mean against bilinear interpolation.
#include <catch2/catch.hpp>
#include <random>

#include "host/image/colour_transfer.h"
#include "host/image/image.h"
#include "tests/trace/reference/scene_builder.h"
#include "tests/trace/render/both_tracers.h"
#include "tests/trace/render/pixel_agreement.h"

using namespace candela;
using namespace candela::device;
using glm::vec2;
using glm::vec3;
using scene::TextureFilter;
using scene::TextureReference;
using scene::TextureWrap;
using test::diffuseMaterial;
using test::SceneBuilder;

namespace {

// An image of random texels, the same for equal arguments.
scene::TextureImage noise(std::uint32_t width, std::uint32_t height, std::uint32_t seed) {
  std::mt19937 random(seed);
  scene::TextureImage image{"noise", width, height, {}};
  for (std::uint32_t i = 0; i < width * height; ++i) image.texels.push_back(static_cast<std::uint32_t>(random()));
  return image;
}

// A square from `corner` along two edges, with coordinates 0 to 1 in set 0, and from -1.3 to 2.1 in set 1.
scene::Mesh square(const vec3& corner, const vec3& u, const vec3& v, bool smooth) {
  scene::Mesh mesh;
  mesh.positions = {corner, corner + u, corner + u + v, corner + v};
  mesh.texCoords[0] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.texCoords[1] = {{-1.3f, -1.3f}, {2.1f, -1.3f}, {2.1f, 2.1f}, {-1.3f, 2.1f}};
  mesh.indices = {0, 1, 2, 0, 2, 3};
  if (smooth) mesh.normals.assign(4, glm::normalize(glm::cross(u, v)));
  return mesh;
}

scene::Material withTexture(scene::Material material, scene::TextureSlot slot, const TextureReference& reference) {
  material.textures[static_cast<std::size_t>(slot)] = reference;
  return material;
}

scene::Material textured(const TextureReference& reference) {
  return withTexture(diffuseMaterial(vec3(0.9f)), scene::TextureSlot::baseColour, reference);
}

// Four upright squares with all wrap modes, both filters and sets, a rotation, and a glossy lobe that is tinted in
// part.
scene::Scene gallery() {
  SceneBuilder b;
  b.scene.images = {noise(7, 5, 1), noise(16, 16, 2)};
  b.material(diffuseMaterial(vec3(0.7f))).plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const auto add = [&](const scene::Material& material, float x, bool smooth) {
    b.material(material);
    addMesh(b.scene, square({x, 0, 0.1f}, {1.5f, 0.2f, 0}, {0, 0, 1.8f}, smooth),
            static_cast<std::uint32_t>(b.scene.materials.size() - 1));
  };
  add(textured({.texCoordSet = 1, .wrapS = TextureWrap::repeat, .wrapT = TextureWrap::mirroredRepeat}), -3.5f, false);
  add(textured({.texCoordSet = 1, .wrapS = TextureWrap::clampToEdge, .wrapT = TextureWrap::repeat}), -1.7f, true);
  add(textured({.image = 1,
                .wrapS = TextureWrap::mirroredRepeat,
                .wrapT = TextureWrap::clampToEdge,
                .filter = TextureFilter::nearest,
                .rowS = {1.2f, 0.7f, -0.3f},
                .rowT = {-0.7f, 1.2f, 0.4f}}),
      0.1f, false);
  add(withTexture(test::mixtureMaterial(0.5f, 0.5f, 20), scene::TextureSlot::baseColour, {.image = 1}), 1.9f, true);
  b.pointLight({-1, -4, 4}, vec3(1));
  b.scene.background = vec3(0.3f);
  b.view({0, -7, 1.5f}, {0, 0, 0.9f}, {0, 0, 1}, 40);
  b.scene.name = "gallery";
  return b.scene;
}

// A floor and a ball below two textured emitters, one of them with a set of coordinates that leaves the image.
scene::Scene texturedLights() {
  SceneBuilder b;
  b.scene.images = {noise(4, 4, 3)};
  b.material(diffuseMaterial(vec3(0.7f))).plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  b.material(test::mixtureMaterial(0.5f, 0.4f, 30)).sphere({0, 0, 0.75f}, 0.75f);
  for (const std::uint8_t set : {std::uint8_t{0}, std::uint8_t{1}}) {
    const TextureReference reference{.texCoordSet = set, .wrapS = TextureWrap::mirroredRepeat};
    b.material(withTexture(diffuseMaterial(vec3(0.5f), {3, 2, 4}), scene::TextureSlot::emission, reference));
    addMesh(b.scene, square({set * 2.0f - 2, -1, 3}, {0, 1.5f, 0}, {1.5f, 0, 0.5f}, set == 1),
            static_cast<std::uint32_t>(b.scene.materials.size() - 1));
  }
  b.view({0, -7, 3}, {0, 0, 1}, {0, 0, 1}, 40);
  b.scene.name = "textured lights";
  return b.scene;
}

// Squares of glass and with a coat, whose textures scale every parameter of a surface; one that emits through its coat,
// and one whose emission has vertex colours. The fence behind them shows through the glass.
scene::Scene texturedSurfaces() {
  SceneBuilder b;
  b.scene.images = {noise(5, 7, 4), noise(4, 4, 5)};
  b.material(diffuseMaterial(vec3(0.7f))).plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  b.material(diffuseMaterial({0.9f, 0.2f, 0.1f})).box({-4, 1, 0}, {4, 1.2f, 1});
  const auto add = [&](scene::Material material, float x, std::vector<glm::vec4> colours = {}) {
    b.material(material);
    scene::Mesh mesh = square({x, 0, 0.1f}, {1.5f, 0.2f, 0}, {0, 0, 1.8f}, x > 0);
    mesh.colours = std::move(colours);
    addMesh(b.scene, mesh, static_cast<std::uint32_t>(b.scene.materials.size() - 1));
  };
  scene::Material material;
  material.surface = scene::SurfaceParameters{.roughness = 0.2f, .transmissionWeight = 1};
  add(withTexture(material, scene::TextureSlot::transmission, {}), -3.5f);
  material.surface = scene::SurfaceParameters{.baseColour = {0.4f, 0.5f, 0.2f}, .coatWeight = 1, .coatRoughness = 0.9f};
  material = withTexture(material, scene::TextureSlot::coat, {.image = 1});
  add(withTexture(material, scene::TextureSlot::coatRoughness, {.texCoordSet = 1}), -1.7f);
  material.emission = {3, 2, 1};
  add(material, 0.1f);
  scene::Material unlit;
  unlit.emission = {1, 2, 2};
  unlit.coloursScaleEmission = true;
  add(unlit, 1.9f, {{1, 0, 0, 1}, {0, 1, 0, 1}, {0.2f, 0.3f, 1, 1}, {0, 0, 0, 1}});
  b.pointLight({-1, -4, 4}, vec3(1));
  b.scene.background = vec3(0.3f);
  b.view({0, -7, 1.5f}, {0, 0, 0.9f}, {0, 0, 1}, 40);
  b.scene.name = "textured surfaces";
  return b.scene;
}

// Three upright squares of cloth with a thin film: the colour of the sheen and the weight of the film have textures on
// the first two, the sheen's roughness and the film's thickness on the last two.
scene::Scene fabrics() {
  SceneBuilder b;
  b.scene.images = {noise(7, 5, 4), noise(16, 16, 5)};
  b.material(diffuseMaterial(vec3(0.7f))).plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  scene::Material cloth;
  cloth.surface = scene::SurfaceParameters{.baseColour = {0.1f, 0.1f, 0.3f}, .roughness = 0.8f};
  cloth.surface->sheenColour = {0.9f, 0.6f, 0.8f};
  cloth.surface->sheenRoughness = 0.9f;
  cloth.surface->filmWeight = 0.9f;
  for (int i = 0; i < 3; ++i) {
    scene::Material material = cloth;
    if (i < 2) {
      material = withTexture(material, scene::TextureSlot::sheenColour, {.image = 0});
      material = withTexture(material, scene::TextureSlot::film, {.image = 1});
    }
    if (i > 0) {
      material = withTexture(material, scene::TextureSlot::sheenRoughness, {.image = 1});
      material = withTexture(material, scene::TextureSlot::filmThickness, {.image = 0});
    }
    b.material(material);
    addMesh(b.scene, square({1.8f * static_cast<float>(i) - 2.6f, 0, 0.1f}, {1.5f, 0.9f, 0}, {0, 0, 1.8f}, i == 1),
            static_cast<std::uint32_t>(b.scene.materials.size() - 1));
  }
  b.pointLight({-4, -3, 3}, vec3(1));
  b.scene.background = vec3(0.3f);
  b.view({0, -7, 1.5f}, {0, 0, 0.9f}, {0, 0, 1}, 40);
  b.scene.name = "fabrics";
  return b.scene;
}

void requireSamePixels(const scene::Scene& scene, std::uint32_t seed, render::SamplerKind sampler,
                       bool nextEventEstimation) {
  render::RenderSettings settings = squareSettings(96, 1);
  settings.image.seed = seed;
  settings.image.sampler = sampler;
  settings.image.nextEventEstimation = nextEventEstimation;
  checkPixelsAgree(scene, settings, nextEventEstimation ? 0.25 : 0.03);
}

double linear(std::uint32_t byte) { return image::srgbDecode(byte / 255.0); }

}  // namespace

TEST_CASE("textures have the reference's pixels at equal seeds") {
  const scene::Scene scene = gallery();
  for (const render::SamplerKind sampler : {render::SamplerKind::sobol, render::SamplerKind::independent}) {
    for (const std::uint32_t seed : {0u, 1u}) requireSamePixels(scene, seed, sampler, true);
  }
}

TEST_CASE("textures of glass and coats have the reference's pixels at equal seeds") {
  const scene::Scene scene = texturedSurfaces();
  for (const std::uint32_t seed : {0u, 1u}) requireSamePixels(scene, seed, render::SamplerKind::sobol, true);
  requireSamePixels(scene, 2, render::SamplerKind::sobol, false);
}

TEST_CASE("light sampling of emitters with coats and vertex colours has the mean of paths without it",
          "[swiftshader-slow]") {
  onBothTracers([](const RenderFunction& render) {
    scene::Scene scene = texturedSurfaces();
    scene.pointLights.clear();
    scene.background = vec3(0);
    render::RenderSettings settings = squareSettings(24, 1024);
    const double sampled = meanLuminance(render(scene, settings).film);
    settings.image.nextEventEstimation = false;
    CHECK(sampled == Approx(meanLuminance(render(scene, settings).film)).epsilon(0.02));
  });
}

TEST_CASE("textures scale the weights of transmission and coat, and vertex colours an emission that says so") {
  // One red texel of 51 / 255, seen from above: the light below passes one fifth of the glass.
  SceneBuilder b;
  b.scene.images = {{"", 1, 1, {0xff000000u | 51u}}};
  b.material(diffuseMaterial(vec3(0), vec3(1))).plane({0, 0, -1}, {1, 0, -1}, {0, 1, -1});
  scene::Material material;
  b.view({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 0.01f);
  scene::Mesh mesh = square({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, false);
  const auto shown = [&](const RenderFunction& render) -> glm::dvec3 {
    scene::Scene scene = b.scene;
    scene.materials.push_back(material);
    addMesh(scene, mesh, 1);
    render::RenderSettings settings = squareSettings(1, 4096);
    settings.image.maxDepth = 2;
    return image::toImage(render(scene, settings).film).at(0, 0);
  };
  SECTION("transmission") {
    material.surface = scene::SurfaceParameters{
        .baseColour = vec3(1), .specularWeight = 0, .roughness = 0.1f, .transmissionWeight = 1};
    material = withTexture(material, scene::TextureSlot::transmission, {});
    onBothTracers([&](const RenderFunction& render) { CHECK(shown(render).x == Approx(0.2).epsilon(0.02)); });
  }
  SECTION("coat, which dims emission") {
    material.surface = scene::SurfaceParameters{.baseColour = vec3(0), .specularWeight = 0, .coatWeight = 1};
    material.emission = vec3(10);
    material = withTexture(material, scene::TextureSlot::coat, {});
    onBothTracers(
        [&](const RenderFunction& render) { CHECK(shown(render).x == Approx(10 * (1 - 0.2 * 0.04)).epsilon(1e-5)); });
  }
  SECTION("vertex colours") {
    material.emission = vec3(10);
    material.coloursScaleEmission = true;
    mesh.colours.assign(4, {0.1f, 0.2f, 0.3f, 1});
    onBothTracers(
        [&](const RenderFunction& render) { CHECK(glm::length(shown(render) - glm::dvec3(1, 2, 3)) < 1e-5); });
  }
}

TEST_CASE("the green channel of a texture scales the roughness, and the blue one the metalness, both linear") {
  // A texel of (0, 102, 204) / 255 beside a surface without a texture that has 0.4 and 0.8 times the parameters.
  const auto film = [](const RenderFunction& render, bool isTextured) {
    SceneBuilder b;
    b.scene.images = {{"", 1, 1, {0xff000000u | 204u << 16 | 102u << 8}}};
    scene::Material material;
    material.surface = scene::SurfaceParameters{.baseColour = {0.9f, 0.6f, 0.3f},
                                                .metalness = isTextured ? 1 : 204 / 255.0f,
                                                .roughness = isTextured ? 1 : 102 / 255.0f};
    if (isTextured) material = withTexture(material, scene::TextureSlot::metallicRoughness, {});
    b.material(material).pointLight({1, -2, 3}, vec3(1)).view({-1, -3, 3}, {0, 0, 0}, {0, 0, 1}, 30);
    b.scene.background = vec3(0.3f);
    addMesh(b.scene, square({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, true), 0);
    return render(b.scene, squareSettings(24, 16)).film;
  };
  onBothTracers([&](const RenderFunction& render) {
    const image::Film textured = film(render, true), plain = film(render, false);
    std::uint32_t different = 0;
    for (std::uint32_t y = 0; y < 24; ++y) {
      for (std::uint32_t x = 0; x < 24; ++x) {
        different += glm::length(textured.mean(x, y) - plain.mean(x, y)) > 1e-4 * glm::length(plain.mean(x, y));
      }
    }
    CHECK(different <= 24 * 24 / 100);
    CHECK(meanLuminance(plain) > 0.05);
  });
}

TEST_CASE("textures of a sheen and of a thin film have the reference's pixels at equal seeds") {
  for (const std::uint32_t seed : {0u, 1u, 2u}) requireSamePixels(fabrics(), seed, render::SamplerKind::sobol, true);
}

TEST_CASE("textured emitters have the reference's pixels at equal seeds") {
  const scene::Scene scene = texturedLights();
  for (const std::uint32_t seed : {0u, 1u, 2u}) requireSamePixels(scene, seed, render::SamplerKind::sobol, true);
  requireSamePixels(scene, 3, render::SamplerKind::sobol, false);
}

TEST_CASE("light sampling of textured emitters has the mean of paths without it", "[swiftshader-slow]") {
  onBothTracers([](const RenderFunction& render) {
    render::RenderSettings settings = squareSettings(24, 1024);
    const double sampled = meanLuminance(render(texturedLights(), settings).film);
    settings.image.nextEventEstimation = false;
    CHECK(sampled == Approx(meanLuminance(render(texturedLights(), settings).film)).epsilon(0.02));
  });
}

TEST_CASE("the mean of many samples is bilinear interpolation between texels") {
  SceneBuilder b;
  b.scene.images = {{"", 2, 2, {0xff0000ffu, 0xff00ff00u, 0xffff0000u, 0xff808080u}}};
  b.material(textured({.wrapS = TextureWrap::clampToEdge, .wrapT = TextureWrap::clampToEdge}));
  addMesh(b.scene, square({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, false), 0);
  b.view({-0.2f, 0.1f, 5}, {-0.2f, 0.1f, 0}, {0, 1, 0}, 0.001f);  // s = 0.4, t = 0.55
  onBothTracers([&](const RenderFunction& render) {
    render::RenderSettings settings = squareSettings(1, 65536);
    settings.image.integrator = render::Integrator::albedo;
    const glm::dvec3 mean = image::toImage(render(b.scene, settings).film).at(0, 0);
    const double s = 0.3;  // of the way from the first texel's centre to the second's
    const double t = 0.6;
    CHECK(mean.x == Approx(0.9 * ((1 - s) * (1 - t) + s * t * linear(128))).epsilon(0.01));
    CHECK(mean.y == Approx(0.9 * (s * (1 - t) + s * t * linear(128))).epsilon(0.01));
    CHECK(mean.z == Approx(0.9 * ((1 - s) * t + s * t * linear(128))).epsilon(0.01));
  });
}

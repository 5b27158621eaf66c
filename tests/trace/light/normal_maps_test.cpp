// Normal maps on both tracers: the same pixels at equal seeds, furnaces, closed forms, and estimators that agree.
#include <catch2/catch.hpp>

#include "host/image/image.h"
#include "tests/trace/light/normal_mapped_meshes.h"
#include "tests/trace/reference/scene_builder.h"
#include "tests/trace/render/both_tracers.h"
#include "tests/trace/render/pixel_agreement.h"

using namespace candela;
using namespace candela::device;
using namespace candela::test;
using glm::vec3;
using scene::SurfaceParameters;
using test::SceneBuilder;

namespace {

struct Looks {
  const char* name;
  SurfaceParameters surface;
};

const std::vector<Looks> kWhite{{"diffuse", {.specularWeight = 0}},
                                {"plastic", {.roughness = 0.3f}},
                                {"smooth metal", {.metalness = 1, .roughness = 0}},
                                {"metal", {.metalness = 1, .roughness = 0.4f}},
                                {"rough metal", {.metalness = 1, .roughness = 1}},
                                {"thin glass", {.roughness = 0.2f, .transmissionWeight = 1}},
                                {"coat", {.specularWeight = 0, .coatWeight = 1, .coatRoughness = 0.2f}}};

scene::Material withMap(scene::Material material, scene::TextureSlot slot) {
  material.textures[static_cast<std::size_t>(slot)].emplace();
  return material;
}

// Balls of all kinds on a mapped floor below an area light and a point light.
scene::Scene bumpyBalls() {
  SceneBuilder b;
  b.scene.images = {bumps(8)};
  b.material(mapped({.baseColour = {0.7f, 0.6f, 0.5f}, .roughness = 0.6f}));
  addMesh(b.scene, flatSquare(6), 0);
  const std::vector<SurfaceParameters> surfaces{
      {.baseColour = {0.9f, 0.7f, 0.3f}, .metalness = 1, .roughness = 0.3f},
      {.baseColour = {0.3f, 0.5f, 0.8f}, .roughness = 0.4f, .coatWeight = 0.8f, .coatRoughness = 0.1f},
      {.baseColour = {0.9f, 0.9f, 0.8f}, .roughness = 0.3f, .transmissionWeight = 0.8f, .isThinWalled = false}};
  float x = -2;
  for (const SurfaceParameters& surface : surfaces) {
    b.material(surface.coatWeight > 0 ? withMap(mapped(surface), scene::TextureSlot::coatNormal) : mapped(surface));
    b.scene.materials.back().normalScale = 0.6f;
    b.scene.materials.back().coatNormalScale = 0.3f;
    addMesh(b.scene, ball({x, 0, 1}, 0.9f, x < 0 ? -3.0f : 3.0f),
            static_cast<std::uint32_t>(b.scene.materials.size() - 1));
    x += 2;
  }
  b.material(test::diffuseMaterial(vec3(0.5f), vec3(6)));
  b.quad({-1, 1, 4}, {-1, -1, 4}, {1, -1, 4}, {1, 1, 4});
  b.pointLight({-4, -4, 4}, vec3(0.3f));
  b.scene.background = vec3(0.3f);
  b.view({0, -7, 3}, {0, 0, 0.8f}, {0, 0, 1}, 45);
  b.scene.name = "bumpy balls";
  return b.scene;
}

void requireSameBumps(std::uint32_t seed, bool nextEventEstimation) {
  render::RenderSettings settings = squareSettings(96, 1);
  settings.image.seed = seed;
  settings.image.maxDepth = 4;
  settings.image.nextEventEstimation = nextEventEstimation;
  checkPixelsAgree(bumpyBalls(), settings);
}

// The fraction of light at this cosine to the surface that reaches bumps with a normal of this cosine.
double unshadowed(double normalCosine, double lightCosine) {
  const double steepness = std::min((1 / (normalCosine * normalCosine) - 1) / 8, 1.0);
  return 2 / (1 + std::sqrt(1 + steepness * (1 / (lightCosine * lightCosine) - 1)));
}

}  // namespace

TEST_CASE("normal maps have the reference's pixels at equal seeds") {
  for (const std::uint32_t seed : {0u, 1u}) requireSameBumps(seed, true);
  requireSameBumps(2, false);
}

TEST_CASE("a white surface below a white sky is white, whatever its normal map", "[swiftshader-slow]") {
  const vec3 eye = GENERATE(vec3(0.3f, -0.2f, 5), vec3(3, 2, 1), vec3(-5, 1, 0.4f));
  onBothTracers([&](const RenderFunction& render) {
    for (const Looks& looks : kWhite) {
      SceneBuilder b;
      b.scene.images = {bumps(8)};
      b.material(mapped(looks.surface)).view(eye, {0, 0, 0}, {0, 1, 0}, 5);
      b.scene.background = vec3(1);
      addMesh(b.scene, flatSquare(20), 0);
      const double mean = meanLuminance(render(b.scene, squareSettings(16, 1024)).film);
      CAPTURE(looks.name, eye.x, mean);
      CHECK(mean > 0.99);
      CHECK(mean < 1.002);
    }
  });
}

TEST_CASE("no direction of a normal-mapped surface is black or gains light") {
  const vec3 eye = GENERATE(vec3(0.3f, -0.2f, 5), vec3(-5, 1, 0.4f));
  onBothTracers([&](const RenderFunction& render) {
    SceneBuilder b;
    b.scene.images = {bumps(8)};
    b.material(mapped({.specularWeight = 0})).view(eye, {0, 0, 0}, {0, 1, 0}, 5);
    b.scene.background = vec3(1);
    addMesh(b.scene, flatSquare(20), 0);
    const image::Image image = image::toImage(render(b.scene, squareSettings(16, 1)).film);
    for (std::uint32_t i = 0; i < 256; ++i) CHECK(image.at(i % 16, i / 16).x == Approx(1).epsilon(1e-4));
  });
}

TEST_CASE("a coat has its own normal map, or none", "[swiftshader-slow]") {
  // The base is black, so that only the coat reflects light: the mirror image of a light on the left in a coat that
  // is not tilted, whatever the map of the base, and in a tilted one that of a light in another place.
  const auto [slot, other] = GENERATE(
      table<scene::TextureSlot, scene::TextureSlot>({{scene::TextureSlot::normal, scene::TextureSlot::coatNormal},
                                                     {scene::TextureSlot::coatNormal, scene::TextureSlot::normal}}));
  SceneBuilder b;
  b.scene.images = {oneTexel(204, 128, 230)};
  scene::Material material;
  material.surface = SurfaceParameters{
      .baseColour = vec3(0), .specularWeight = 0, .coatWeight = 1, .coatRoughness = 0.3f};
  b.material(withMap(material, slot)).view({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 1);
  addMesh(b.scene, flatSquare(1), 0);
  scene::PunctualLight light;
  light.kind = scene::PunctualLight::Kind::directional;
  light.direction = {0, 0, -1};
  light.intensity = vec3(1);
  b.scene.punctualLights.push_back(light);
  const bool isTilted = slot == scene::TextureSlot::coatNormal;
  onBothTracers([&, other = other](const RenderFunction& render) {
    const double mean = meanLuminance(render(b.scene, squareSettings(16, 1024)).film);
    scene::Scene both = b.scene;
    both.materials[0] = withMap(both.materials[0], other);
    const double withBoth = meanLuminance(render(both, squareSettings(16, 1024)).film);
    scene::Scene none = b.scene;
    none.materials[0] = material;
    const double without = meanLuminance(render(none, squareSettings(16, 16)).film);
    if (isTilted) CHECK(mean == Approx(withBoth).epsilon(0.05));
    if (isTilted) CHECK(mean < 0.5 * without);
    if (!isTilted) CHECK(mean == Approx(without).epsilon(0.05));
    if (!isTilted) CHECK(withBoth < 0.5 * without);
  });
}

TEST_CASE("a tilted normal shades a directional light by its cosine, and by the light of other facets") {
  // The normal (0.6 0.2 0.773), light from (0.6 0 0.8), from which only the direct facet is seen.
  SceneBuilder b;
  b.scene.images = {oneTexel(204, 153, 226)};
  b.material(mapped({.baseColour = {0.5f, 0.5f, 0.5f}, .specularWeight = 0})).view({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 1);
  addMesh(b.scene, flatSquare(1), 0);
  scene::PunctualLight light;
  light.kind = scene::PunctualLight::Kind::directional;
  light.direction = {-0.6f, 0, -0.8f};
  light.intensity = vec3(2);
  b.scene.punctualLights.push_back(light);
  const glm::dvec3 normal = glm::normalize(glm::dvec3(204, 153, 226) / 127.5 - 1.0);
  const double cosine = glm::dot(normal, glm::dvec3(0.6, 0, 0.8)) + (1 - normal.z) / 2 * 0.8;
  onBothTracers([&](const RenderFunction& render) {
    const double mean = meanLuminance(render(b.scene, squareSettings(4, 16)).film);
    CHECK(mean == Approx(0.5 / 3.14159265358979 * 2 * cosine).epsilon(1e-3));
  });
}

TEST_CASE("low lights are hardly brighter on diffuse facets than their cosine, which bumps shadow without facets") {
  // The normal is tilted to the left by 53 degrees. Light from the right that is low is below the facet's horizon.
  SceneBuilder b;
  b.scene.images = {oneTexel(26, 128, 204)};
  b.material(mapped({.specularWeight = 0})).view({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 1);
  addMesh(b.scene, flatSquare(1), 0);
  scene::PunctualLight light;
  light.kind = scene::PunctualLight::Kind::directional;
  light.intensity = vec3(3.14159265f);
  const double height = GENERATE(0.05, 0.17, 0.5, 0.9);
  const double side = GENERATE(-1, 1);
  const glm::dvec3 normal = glm::normalize(glm::dvec3(26, 128, 204) / 127.5 - 1.0);
  const glm::dvec3 towards(side * std::sqrt(1 - height * height), 0, height);
  light.direction = vec3(-towards);
  b.scene.punctualLights = {light};
  const double direct = std::max(0.0, glm::dot(normal, towards));
  const double expected = direct + (1 - normal.z) / 2 * height;
  scene::Scene replaced = b.scene;
  replaced.materials[0].hasFacets = false;
  onBothTracers([&](const RenderFunction& render) {
    CHECK(meanLuminance(render(b.scene, squareSettings(4, 16)).film) == Approx(expected).epsilon(1e-3));
    CHECK(meanLuminance(render(replaced, squareSettings(4, 16)).film) ==
          Approx(direct * unshadowed(normal.z, height)).epsilon(1e-3).margin(1e-6));
  });
}

TEST_CASE("between texels, facets have the light of both normals, and a map without facets the interpolated normal") {
  // Texels whose normals are tilted to the left and to the right by 53 degrees, as seen at their common edge.
  SceneBuilder b;
  b.scene.images = {{"tilted", 2, 1, {0xffcc801a, 0xffcc80e6}, {}}};
  b.material(mapped({.specularWeight = 0})).view({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 0.01f);
  addMesh(b.scene, flatSquare(1), 0);
  scene::PunctualLight light;
  light.kind = scene::PunctualLight::Kind::directional;
  light.intensity = vec3(3.14159265f);
  light.direction = {-0.8f, 0, -0.6f};
  b.scene.punctualLights = {light};
  const glm::dvec3 left = glm::normalize(glm::dvec3(26, 128, 204) / 127.5 - 1.0), towards(0.8, 0, 0.6);
  const glm::dvec3 right = glm::normalize(glm::dvec3(230, 128, 204) / 127.5 - 1.0);
  const glm::dvec3 between = glm::normalize(glm::dvec3(128, 128, 204) / 127.5 - 1.0);
  const double direct = (std::max(0.0, glm::dot(left, towards)) + std::max(0.0, glm::dot(right, towards))) / 2;
  scene::Scene replaced = b.scene;
  replaced.materials[0].hasFacets = false;
  onBothTracers([&](const RenderFunction& render) {
    CHECK(meanLuminance(render(b.scene, squareSettings(16, 256)).film) ==
          Approx(direct + (1 - left.z) / 2 * towards.z).epsilon(5e-3));
    CHECK(meanLuminance(render(replaced, squareSettings(4, 16)).film) ==
          Approx(glm::dot(between, towards) * unshadowed(between.z, towards.z)).epsilon(1e-3));
  });
}

TEST_CASE("without facets, a mapped normal that faces away from the eye is turned about the surface's") {
  // The normal is tilted to the left by 53 degrees, and the eye is low on either side: on the right, it sees the normal
  // tilted to the right.
  SceneBuilder b;
  b.scene.images = {oneTexel(26, 128, 204)};
  b.material(mapped({.specularWeight = 0}));
  b.scene.materials[0].hasFacets = false;
  addMesh(b.scene, flatSquare(1), 0);
  scene::PunctualLight light;
  light.kind = scene::PunctualLight::Kind::directional;
  light.intensity = vec3(3.14159265f);
  const glm::dvec3 towards(0.6, 0, 0.8);
  light.direction = vec3(-towards);
  b.scene.punctualLights = {light};
  const glm::dvec3 normal = glm::normalize(glm::dvec3(26, 128, 204) / 127.5 - 1.0);
  onBothTracers([&](const RenderFunction& render) {
    for (const double side : {-1.0, 1.0}) {
      b.view({static_cast<float>(5 * side), 0, 1}, {0, 0, 0}, {0, 0, 1}, 0.1f);
      const glm::dvec3 seen = side < 0 ? normal : glm::dvec3(-normal.x, -normal.y, normal.z);
      const double expected = std::max(0.0, glm::dot(seen, towards));
      CHECK(meanLuminance(render(b.scene, squareSettings(4, 16)).film) ==
            Approx(expected * unshadowed(normal.z, 0.8)).epsilon(1e-3).margin(1e-6));
    }
  });
}

TEST_CASE("facets and the mirrors between them are seen in proportion to their projected areas", "[swiftshader-slow]") {
  // The normal is tilted by 30 degrees to the right, and the eye is 45 degrees to the left. Facets reflect it to the
  // horizon on the right; those that are seen in a mirror reflect it to a light near the zenith.
  SceneBuilder b;
  b.scene.images = {oneTexel(191, 128, 238)};
  const vec3 eye(-1, 0, 1);
  b.material(mapped({.metalness = 1, .roughness = 0})).view(5.0f * eye, {0, 0, 0}, {0, 1, 0}, 1);
  addMesh(b.scene, flatSquare(1), 0);
  b.material(test::diffuseMaterial(vec3(0), vec3(1)));
  b.quad({-1, 3, 6}, {-1, -3, 6}, {5, -3, 6}, {5, 3, 6});
  const glm::dvec3 normal = glm::normalize(glm::dvec3(191, 128, 238) / 127.5 - 1.0);
  const double facet = glm::dot(normal, glm::dvec3(eye));
  const double mirror = -glm::dot(glm::dvec3(normal.x, normal.y, 0), glm::dvec3(eye));
  onBothTracers([&](const RenderFunction& render) {
    const double mean = meanLuminance(render(b.scene, squareSettings(16, 1024)).film);
    CHECK(mean == Approx(mirror / (facet + mirror)).epsilon(0.01));
  });
}

TEST_CASE("specular lobes mirror what is below the surface") {
  // The metal's normal is tilted by 45 degrees to the right, so that an eye above it sees the horizon there. An eye 20
  // degrees to the left sees 20 degrees below the horizon, whose mirror image is the light.
  SceneBuilder b;
  b.scene.images = {oneTexel(218, 128, 218)};
  b.material(mapped({.metalness = 1, .roughness = 0.1f})).view({-0.342f * 5, 0, 0.94f * 5}, {0, 0, 0}, {0, 1, 0}, 1);
  addMesh(b.scene, flatSquare(1), 0);
  b.material(test::diffuseMaterial(vec3(0), vec3(1)));
  b.quad({9.4f, -4, 1.4f}, {9.4f, 4, 1.4f}, {9.4f, 4, 5.4f}, {9.4f, -4, 5.4f});
  onBothTracers([&](const RenderFunction& render) {
    CHECK(meanLuminance(render(b.scene, squareSettings(8, 256)).film) == Approx(1).epsilon(0.02));
  });
}

TEST_CASE("light sampling of a diffuse facet has the mean of paths without it, at a low light", "[swiftshader-slow]") {
  // Paths find the light by directions that are scattered again, too.
  SceneBuilder b;
  b.scene.images = {oneTexel(218, 128, 218)};
  b.material(mapped({.specularWeight = 0})).view({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 1);
  addMesh(b.scene, flatSquare(1), 0);
  const float side = GENERATE(-1.0f, 1.0f);
  b.material(test::diffuseMaterial(vec3(0), vec3(1)));
  b.quad({side * 8, -6, 0.1f}, {side * 8, 6, 0.1f}, {side * 8, 6, 4}, {side * 8, -6, 4});
  onBothTracers([&](const RenderFunction& render) {
    render::RenderSettings settings = squareSettings(16, 2048);
    settings.image.maxDepth = 2;
    const double sampled = meanLuminance(render(b.scene, settings).film);
    settings.image.nextEventEstimation = false;
    CHECK(sampled == Approx(meanLuminance(render(b.scene, settings).film)).epsilon(0.01));
  });
}

TEST_CASE("light sampling of normal-mapped surfaces has the mean of paths without it", "[swiftshader-slow]") {
  onBothTracers([](const RenderFunction& render) {
    render::RenderSettings settings = squareSettings(16, 4096);
    settings.image.maxDepth = 2;
    scene::Scene scene = bumpyBalls();
    scene.pointLights.clear();
    scene.background = vec3(0);
    const double sampled = meanLuminance(render(scene, settings).film);
    settings.image.nextEventEstimation = false;
    CHECK(sampled == Approx(meanLuminance(render(scene, settings).film)).epsilon(0.02));
  });
}

TEST_CASE("the view of normals shows mapped normals, and ambient occlusion those of the mesh") {
  SceneBuilder b;
  b.scene.images = {oneTexel(204, 153, 226)};
  b.material(mapped({})).view({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 1);
  addMesh(b.scene, flatSquare(1), 0);
  const glm::dvec3 normal = glm::normalize(glm::dvec3(204, 153, 226) / 127.5 - 1.0);
  onBothTracers([&](const RenderFunction& render) {
    render::RenderSettings settings = squareSettings(1, 16);
    settings.image.integrator = render::Integrator::normal;
    const glm::dvec3 shown = image::toImage(render(b.scene, settings).film).at(0, 0);
    CHECK(glm::length(shown - (normal + 1.0) / 2.0) < 1e-5);
    settings.image.integrator = render::Integrator::ao;
    CHECK(meanLuminance(render(b.scene, settings).film) == 1);
  });
}

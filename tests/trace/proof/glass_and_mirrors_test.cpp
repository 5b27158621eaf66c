// Specular light with closed forms: a corridor of two mirrors, and a slab of glass.
#include <catch2/catch.hpp>

#include "tests/trace/proof/leaves.h"
#include "tests/trace/reference/scene_builder.h"

using namespace candela;
using namespace candela::proof;
using glm::vec3;
using test::diffuseMaterial;
using test::glassMaterial;
using test::mirrorMaterial;
using test::SceneBuilder;

namespace {

render::RenderSettings longPaths(std::uint32_t width, std::uint32_t height, std::uint32_t samples) {
  render::RenderSettings settings = test::settingsOf(width, height, samples);
  settings.image.rouletteStart = settings.image.maxDepth;
  return settings;
}

// With Schlick's reflectance at both faces, which the cosine outside gives. `colour` is taken at every crossing and at
// every reflection.
struct Slab {
  double reflectance;
  double colour;

  Slab(double cosOutside, double ior, double taken) : colour(taken) {
    const double atNormal = std::pow((ior - 1) / (ior + 1), 2);
    reflectance = atNormal + (1 - atNormal) * std::pow(1 - cosOutside, 5);
  }
  // (1 - R)^2 c^2 (1 + (R c)^2 + (R c)^4 + ...)
  double transmitted() const {
    return std::pow((1 - reflectance) * colour, 2) / (1 - std::pow(reflectance * colour, 2));
  }
  // R c, and the light that enters, is reflected an odd number of times, and exits.
  double reflected() const { return reflectance * colour + reflectance * colour * transmitted(); }
};

}  // namespace

TEST_CASE("the end of a corridor of two mirrors is attenuated once per reflection, as unfolding predicts") {
  // Mirrors at x = 0 and x = 1, one of them of triangles, and a glowing end at y = 8. The camera looks along y.
  constexpr double kStart = 0.375, kLength = 8;
  constexpr std::uint32_t kColumns = 512, kRows = 4;
  SceneBuilder b;
  b.material(mirrorMaterial({0.9f, 0.7f, 0.5f}));
  b.plane({0, 0, 0}, {0, 1, 0}, {0, 0, 1}).quad({1, -9, -9}, {1, 9, -9}, {1, 9, 9}, {1, -9, 9});
  b.material(diffuseMaterial(vec3(0), {1, 2, 3})).plane({0, kLength, 0}, {0, kLength, 1}, {1, kLength, 0});
  b.view({kStart, 0, 0}, {kStart, 1, 0}, {0, 0, 1}, 2.7f);
  render::RenderSettings settings = longPaths(kColumns, kRows, 1);
  settings.image.nextEventEstimation = false;
  const render::RenderResult result = renderScene(b.scene, settings);

  // The position at which the straight ray through the image's column `x` ends, in the row of mirrored corridors of
  // width 1.
  const double width = 2 * std::tan(b.scene.camera->angle * std::numbers::pi / 360) * kColumns / kRows;
  const auto corridorAt = [&](double x) {
    return static_cast<int>(std::floor(kStart + kLength * width * (x / kColumns - 0.5)));
  };
  int checked = 0, mostMirrors = 0;
  for (std::uint32_t x = 0; x < kColumns; ++x) {
    const int mirrors = std::abs(corridorAt(x));
    if (corridorAt(x) != corridorAt(x + 1)) continue;
    ++checked;
    mostMirrors = std::max(mostMirrors, mirrors);
    const dvec3 expected(std::pow(double{0.9f}, mirrors), 2 * std::pow(double{0.7f}, mirrors),
                         3 * std::pow(0.5, mirrors));
    CAPTURE(x, mirrors);
    CHECK(length(result.film.mean(x, 1) - expected) < 10 * kRounding * length(expected) + 1e-11);  // the film's grain
  }
  CHECK(checked > 400);
  CHECK(mostMirrors >= 20);
}

TEST_CASE("a slab of glass transmits and reflects the sums of the series of its inner reflections",
          "[swiftshader-slow]") {
  for (const double degrees : {0.0, 45.0, 70.0}) {
    const double angle = degrees * std::numbers::pi / 180;
    SceneBuilder b;
    b.material(glassMaterial(vec3(0.875f), 1.5f)).box({-1000, -1000, -1}, {1000, 1000, 0});
    b.material(diffuseMaterial(vec3(0), {1, 0, 0})).plane({0, 0, -2}, {1, 0, -2}, {0, 1, -2});
    b.scene.background = {0, 1, 0};
    b.view(vec3(5 * std::sin(angle), 0, 5 * std::cos(angle)), {0, 0, 0}, {0, 1, 0}, 1e-3f);
    render::RenderSettings settings = longPaths(16, 16, 1024);
    settings.image.nextEventEstimation = false;
    const dvec3 shown = test::meanOf(renderScene(b.scene, settings).film);
    const Slab slab(std::cos(angle), 1.5, 0.875);
    CAPTURE(degrees);
    CHECK(shown.x == Approx(slab.transmitted()).margin(2e-3));
    CHECK(shown.y == Approx(slab.reflected()).margin(2e-3));
  }
}

TEST_CASE("a slab of absorbing glass shows the light that is left, and its volume is entered and left once each") {
  constexpr double kThickness = 0.5, kReflectance = 0.04;
  const vec3 absorption(0.5f, 1, 3);
  scene::Material glass;
  glass.surface = {.roughness = 0, .transmissionWeight = 1, .isThinWalled = false, .absorption = absorption};
  SceneBuilder b;
  b.material(glass).box({-50, -50, -kThickness}, {50, 50, 0});
  b.scene.background = vec3(1);
  b.view({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 1);
  render::RenderSettings settings = longPaths(16, 16, 256);
  const render::RenderResult result = renderScene(b.scene, longPaths(16, 16, 256));
  for (int c = 0; c < 3; ++c) {
    const double left = std::exp(-double{absorption[c]} * kThickness);
    const double expected = kReflectance + std::pow(1 - kReflectance, 2) * left / (1 - kReflectance * left);
    CHECK(test::meanOf(result.film)[c] == Approx(expected).epsilon(0.01));
  }
  CHECK(result.statistics.volumeFaults == 0);
}

TEST_CASE("volumes that are open or overlap are counted") {
  scene::Material glass;
  glass.surface = {.roughness = 0, .transmissionWeight = 1, .isThinWalled = false};
  SceneBuilder open;
  open.material(glass).quad({-50, -50, 0}, {50, -50, 0}, {50, 50, 0}, {-50, 50, 0});
  open.view({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 1);
  CHECK(renderScene(open.scene, longPaths(8, 8, 16)).statistics.volumeFaults > 8 * 8 * 16 / 2);
  SceneBuilder nested;
  nested.material(glass).box({-50, -50, -1}, {50, 50, 0}).material(glass).box({-50, -50, -2}, {50, 50, -0.5f});
  nested.view({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 1);
  CHECK(renderScene(nested.scene, longPaths(8, 8, 16)).statistics.volumeFaults > 8 * 8 * 16 / 2);
}

TEST_CASE("bodies of rough glass and of glass with metal absorb less than 1 percent over all their inner reflections",
          "[swiftshader-slow]") {
  // Light leaves a body of the mixture after about ten reflections.
  const auto body = [](float roughness, float metalness, float transmission) {
    scene::Material material;
    material.surface = {
        .metalness = metalness, .roughness = roughness, .transmissionWeight = transmission, .isThinWalled = false};
    return material;
  };
  for (const scene::Material& material : {body(1, 0, 1), body(0.35f, 0.5f, 0.5f), body(1, 0.5f, 0.5f)}) {
    SceneBuilder b;
    b.material(material).sphere({0, 0, 0}, 1);
    b.scene.background = vec3(1);
    b.view({0, 0, 9}, {0, 0, 0}, {0, 1, 0}, 11);
    const double mean = test::meanOf(renderScene(b.scene, longPaths(16, 16, 4096)).film).x;
    CAPTURE(material.surface->roughness, material.surface->metalness, mean);
    CHECK(mean >= 0.994);
    CHECK(mean <= 1.004);  // 1.001 and twice the noise
  }
}

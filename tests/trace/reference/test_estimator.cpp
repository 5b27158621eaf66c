// The whole estimator, compared with results that are known exactly or on which two kinds of estimates must agree.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/trace/reference/estimate.h"
#include "tests/trace/reference/scene_builder.h"

using namespace candela;
using namespace candela::test;

namespace {

void checkEqualMeans(const Estimate& a, const Estimate& b, double largestError) {
  INFO(a.mean << " +- " << a.error << " against " << b.mean << " +- " << b.error);
  const double error = std::hypot(a.error, b.error);
  CHECK(error < largestError * a.mean);  // otherwise the next check would be weak
  CHECK(std::abs(a.mean - b.mean) < 4 * error);
}

SceneBuilder closedBox(const scene::Material& material) {
  SceneBuilder b;
  b.material(material);
  b.quad({-1, -1, 1}, {1, -1, 1}, {1, -1, -1}, {-1, -1, -1}).quad({-1, 1, -1}, {1, 1, -1}, {1, 1, 1}, {-1, 1, 1});
  b.quad({-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}).quad({-1, 1, 1}, {1, 1, 1}, {1, -1, 1}, {-1, -1, 1});
  b.quad({-1, -1, 1}, {-1, -1, -1}, {-1, 1, -1}, {-1, 1, 1}).quad({1, -1, -1}, {1, -1, 1}, {1, 1, 1}, {1, 1, -1});
  return b.view({0.2f, 0.1f, 0.7f}, {0, 0, 0}, {0, 1, 0}, 90);
}

// A camera that looks down at one point of the plane z = 0, nearly without any extent.
SceneBuilder& lookDownAt(SceneBuilder& b, float x, float y) { return b.view({x, y, 2}, {x, y, 0}, {0, 1, 0}, 1e-3f); }

render::RenderSettings onePixel(std::uint32_t sampleCount, std::uint32_t maxDepth = 64) {
  render::RenderSettings settings = settingsOf(1, 1, sampleCount);
  settings.image.maxDepth = maxDepth;
  return settings;
}

}  // namespace

TEST_CASE("a closed furnace of albedo a shows 1 / (1 - a) everywhere") {
  SceneBuilder box = closedBox(diffuseMaterial(vec3(0.5f), vec3(1)));
  render::RenderSettings settings = settingsOf(16, 16, 4);

  settings.image.nextEventEstimation = false;
  settings.image.rouletteStart = 64;
  const render::RenderResult plain = renderScene(box.scene, settings);
  for (std::uint32_t i = 0; i < 16; ++i) CHECK(plain.film.mean(i, i).y == Approx(2).epsilon(1e-9));

  settings.image.nextEventEstimation = true;
  settings.image.sampleCount = 256;
  CHECK(meanOf(renderScene(box.scene, settings).film).x == Approx(2).epsilon(1e-3));

  settings.image.nextEventEstimation = false;
  settings.image.rouletteStart = 5;  // by it the standard deviation of a sample is less than 0.25
  CHECK(meanOf(renderScene(box.scene, settings).film).x == Approx(2).epsilon(2e-3));
}

TEST_CASE("furnaces of every primitive show 1 / (1 - a)") {
  render::RenderSettings settings = settingsOf(8, 8, 4);
  settings.image.rouletteStart = 64;
  const auto checkFurnace = [&](SceneBuilder& b, double expected) {
    b.view({0.2f, 0.1f, 0.3f}, {0, 0, 0}, {0, 1, 0}, 90);
    const dvec3 mean = meanOf(renderScene(b.scene, settings).film);
    CHECK(mean.x == Approx(expected).epsilon(1e-3));
  };
  const scene::Material wall = diffuseMaterial(vec3(0.5f), vec3(1));

  SceneBuilder box;
  box.material(wall).box({-1, -1, -1}, {1, 1, 1});
  checkFurnace(box, 2);

  SceneBuilder cylinder;
  cylinder.material(wall).cone({0, 0, -1}, 1, {0, 0, 1}, 1);
  cylinder.plane({0, 0, -1}, {1, 0, -1}, {0, 1, -1}).plane({0, 0, 1}, {1, 0, 1}, {0, 1, 1});
  checkFurnace(cylinder, 2);

  SceneBuilder cones;
  cones.material(wall).cone({0, 0, -1}, 0, {0, 0, 0}, 1).cone({0, 0, 0}, 1, {0, 0, 1}, 0);
  checkFurnace(cones, 2);

  SceneBuilder mirrors;
  scene::Material glowingMirror = mirrorMaterial(vec3(0.5f));
  glowingMirror.emission = vec3(1);
  mirrors.material(glowingMirror).box({-1, -1, -1}, {1, 1, 1});
  checkFurnace(mirrors, 2);

  settings.image.nextEventEstimation = false;
  SceneBuilder ball;
  ball.material(wall).sphere({0, 0, 0}, 1);
  checkFurnace(ball, 2);

  SceneBuilder inwardBall;
  inwardBall.material(wall).sphere({0, 0, 0}, -1);
  checkFurnace(inwardBall, 2);
}

TEST_CASE("next-event estimation preserves the mean of a spherical furnace") {
  for (const float radius : {1.0f, -1.0f}) {
    SceneBuilder ball;
    ball.material(diffuseMaterial(vec3(0.5f), vec3(1))).sphere({0, 0, 0}, radius);
    ball.view({0.2f, 0.1f, 0.3f}, {0, 0, 0}, {0, 1, 0}, 90);
    CHECK(meanOf(renderScene(ball.scene, settingsOf(16, 16, 256)).film).x == Approx(2).epsilon(1e-3));
  }
}

TEST_CASE("walls of radius 100,000 make a furnace without acne or leaks") {
  SceneBuilder b;
  b.material(diffuseMaterial(vec3(0.5f), vec3(1)));
  b.sphere({1e5f + 1, 40.8f, 81.6f}, 1e5f).sphere({-1e5f + 99, 40.8f, 81.6f}, 1e5f);
  b.sphere({50, 40.8f, 1e5f}, 1e5f).sphere({50, 40.8f, -1e5f + 170}, 1e5f);
  b.sphere({50, 1e5f, 81.6f}, 1e5f).sphere({50, -1e5f + 81.6f, 81.6f}, 1e5f);
  b.material(glassMaterial(vec3(1), 1.5f)).sphere({73, 16.5f, 78}, 16.5f);
  b.view({50, 52, 160}, {50, 48, 100}, {0, 1, 0}, 60);
  render::RenderSettings settings = settingsOf(24, 24, 4);
  settings.image.nextEventEstimation = false;
  settings.image.rouletteStart = 64;
  const render::RenderResult result = renderScene(b.scene, settings);
  for (std::uint32_t y = 0; y < 24; ++y) {
    for (std::uint32_t x = 0; x < 24; ++x) {
      // Paths that end inside the glass, or spend many vertices there, miss a little.
      CHECK(result.film.mean(x, y).x == Approx(2).epsilon(1e-6));
    }
  }
}

TEST_CASE("colourless glass is invisible in any furnace") {
  SceneBuilder b = closedBox(diffuseMaterial(vec3(0.5f), vec3(1)));
  b.material(glassMaterial(vec3(1), 1.5f));
  b.sphere({-0.4f, 0, 0}, 0.3f).box({0.1f, -0.3f, -0.3f}, {0.6f, 0.3f, 0.1f});
  b.cone({0, 0.5f, 0}, 0.3f, {0, 0.9f, 0}, 0.1f);
  render::RenderSettings settings = settingsOf(24, 24, 9);
  settings.image.maxDepth = 400;
  settings.image.rouletteStart = 400;
  settings.image.nextEventEstimation = false;
  CHECK(meanOf(renderScene(b.scene, settings).film).x == Approx(2).epsilon(1e-3));
}

TEST_CASE("a spherical light over a plane gives the irradiance of the closed form") {
  // E = pi L (R / d)^2 cos; radiance a E / pi = a L R^2 h / d^3.
  SceneBuilder b;
  b.material(diffuseMaterial(vec3(0.8f))).plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  b.material(diffuseMaterial(vec3(0), vec3(5))).sphere({0, 0, 2.5f}, 0.5f);
  for (const float x : {1.0f, 2.0f}) {
    lookDownAt(b, x, 0);
    const double expected = double{0.8f} * 5 * 0.25 * 2.5 / std::pow(x * x + 2.5 * 2.5, 1.5);
    render::RenderSettings settings = onePixel(1024);
    CHECK(renderScene(b.scene, settings).film.mean(0, 0).x == Approx(expected).epsilon(2e-3));
    settings.image.sampleCount = 65536;
    settings.image.nextEventEstimation = false;
    CHECK(renderScene(b.scene, settings).film.mean(0, 0).x == Approx(expected).epsilon(1e-2));
  }
}

TEST_CASE("a point light gives Kd Lc cd (N.L), with and without next-event estimation") {
  SceneBuilder b;
  scene::Material material = mixtureMaterial(0.5f, 0, 1);
  material.diffuse->colour = {0.25f, 0.5f, 1};
  b.material(material).plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  b.pointLight({3e7f, 0, 4e7f}, {2, 4, 8});  // N.L = 0.8
  lookDownAt(b, 1, 1);
  for (const bool nextEvent : {true, false}) {
    render::RenderSettings settings = onePixel(1);
    settings.image.nextEventEstimation = nextEvent;
    const dvec3 seen = renderScene(b.scene, settings).film.mean(0, 0);
    CHECK(seen.x == Approx(0.5 * 2 * 0.25 * 0.8).epsilon(1e-7));
    CHECK(seen.y == Approx(0.5 * 4 * 0.5 * 0.8).epsilon(1e-7));
    CHECK(seen.z == Approx(0.5 * 8 * 1 * 0.8).epsilon(1e-7));
  }
  b.material(diffuseMaterial(vec3(1))).sphere({4, 1, 4}, 0.5f);  // between the surface and the light
  CHECK(renderScene(b.scene, onePixel(1)).film.mean(0, 0) == dvec3(0));
}

TEST_CASE("the contributions of many point lights add up") {
  SceneBuilder b;
  b.material(diffuseMaterial(vec3(1))).plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  b.pointLight({0, 0, 5}, vec3(1)).pointLight({0, 0, 7}, vec3(3)).pointLight({0, 0, 9}, vec3(0.5f));
  b.material(diffuseMaterial(vec3(0), vec3(2))).sphere({0, 0, 12}, 1);  // seen by its cap: 2 / 144
  lookDownAt(b, 0, 0);
  // The light does not occlude the point lights, and they do not occlude it.
  CHECK(renderScene(b.scene, onePixel(65536, 2)).film.mean(0, 0).x == Approx(4.5 + 2.0 / 144).epsilon(5e-3));
}

TEST_CASE("next-event estimation preserves the mean of a box with every kind of surface") {
  SceneBuilder b = closedBox(mixtureMaterial(0.5f, 0.2f, 20));
  b.scene.materials[0].diffuse->colour = {0.8f, 0.6f, 0.4f};
  b.material(diffuseMaterial(vec3(0.3f), vec3(4))).sphere({-0.4f, 0.4f, -0.3f}, 0.4f);
  b.quad({0.2f, 0.9f, -0.6f}, {0.9f, 0.9f, -0.6f}, {0.9f, 0.9f, 0.4f}, {0.2f, 0.9f, 0.4f});
  b.material(mirrorMaterial(vec3(0.9f))).sphere({0.4f, -0.7f, -0.3f}, 0.3f);
  b.material(glassMaterial(vec3(0.9f), 1.5f)).box({-0.6f, -1, -0.5f}, {-0.1f, -0.5f, 0});
  b.material(mixtureMaterial(0.2f, 0.5f, 300, 0.3f, 1.4f)).sphere({0, 0, -0.6f}, 0.3f);
  render::RenderSettings settings = settingsOf(24, 24, 256);
  settings.image.sampler = render::SamplerKind::independent;
  const Estimate with = estimateOf(renderScene(b.scene, settings).film);
  settings.image.nextEventEstimation = false;
  settings.image.seed = 1;
  checkEqualMeans(with, estimateOf(renderScene(b.scene, settings).film), 0.005);
}

TEST_CASE("next-event estimation preserves the mean of a glossy surface under large lights") {
  SceneBuilder b;
  b.material(mixtureMaterial(0.3f, 0.7f, 50)).plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  b.material(diffuseMaterial(vec3(0), vec3(1)));
  b.quad({-2, 1, 0.2f}, {2, 1, 0.2f}, {2, 2, 2}, {-2, 2, 2}).sphere({0, -1, 1}, 0.8f);
  b.scene.background = {0.3f, 0.3f, 0.3f};
  b.view({0, -4, 1.5f}, {0, 0, 0.2f}, {0, 0, 1}, 40);
  render::RenderSettings settings = settingsOf(24, 24, 256);
  settings.image.sampler = render::SamplerKind::independent;
  settings.image.maxDepth = 2;
  const Estimate with = estimateOf(renderScene(b.scene, settings).film);
  settings.image.nextEventEstimation = false;
  settings.image.seed = 1;
  checkEqualMeans(with, estimateOf(renderScene(b.scene, settings).film), 0.005);
}

TEST_CASE("one-sided lights emit only from their front, with and without next-event estimation") {
  SceneBuilder b;
  b.material(diffuseMaterial(vec3(0.9f))).plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  b.material(diffuseMaterial(vec3(0), vec3(3)));
  b.quad({-2, 2, 1}, {2, 2, 1}, {2, -2, 1}, {-2, -2, 1});  // its front is below
  lookDownAt(b, 3, 0);
  render::RenderSettings settings = onePixel(16384);
  settings.image.oneSided = true;
  settings.image.sampler = render::SamplerKind::independent;
  const Estimate front = estimateOf(renderScene(b.scene, settings).film);
  settings.image.nextEventEstimation = false;
  checkEqualMeans(front, estimateOf(renderScene(b.scene, settings).film), 0.03);

  std::vector<vec3>& positions = b.scene.meshes.at(0).positions;
  for (std::size_t i = 0; i < positions.size(); i += 3) std::swap(positions[i + 1], positions[i + 2]);
  for (const bool nextEvent : {true, false}) {
    settings.image.nextEventEstimation = nextEvent;
    CHECK(estimateOf(renderScene(b.scene, settings).film).mean == 0);
  }
}

TEST_CASE("Russian roulette preserves the mean") {
  SceneBuilder b = closedBox(diffuseMaterial({0.8f, 0.7f, 0.6f}));
  b.material(diffuseMaterial(vec3(0.2f), vec3(5))).sphere({0, 0.3f, -0.3f}, 0.5f);
  render::RenderSettings settings = settingsOf(16, 16, 100);
  settings.image.sampler = render::SamplerKind::independent;
  settings.image.rouletteStart = 64;
  const render::RenderResult without = renderScene(b.scene, settings);
  settings.image.rouletteStart = 1;
  settings.image.seed = 1;
  const render::RenderResult with = renderScene(b.scene, settings);
  CHECK(with.statistics.vertices * 2 < without.statistics.vertices);
  checkEqualMeans(estimateOf(without.film), estimateOf(with.film), 0.01);
}

TEST_CASE("a path between two parallel mirrors can have 5000 rays") {
  SceneBuilder b;
  scene::Material material = mirrorMaterial(vec3(0.999f));
  material.emission = vec3(1);
  b.material(material).plane({0, 0, -1}, {1, 0, -1}, {0, 1, -1}).plane({0, 0, 1}, {1, 0, 1}, {0, 1, 1});
  b.view({0, 0, 0}, {0, 0.1f, 1}, {0, 1, 0}, 5);
  render::RenderSettings settings = settingsOf(2, 2, 2);
  settings.image.maxDepth = 5000;
  settings.image.rouletteStart = 5000;
  const render::RenderResult result = renderScene(b.scene, settings);
  CHECK(result.statistics.vertices == 8 * 5000);
  const double a = double{0.999f};
  const double expected = (1 - std::pow(a, 5000)) / (1 - a);
  for (std::uint32_t i = 0; i < 4; ++i) CHECK(result.film.mean(i % 2, i / 2).y == Approx(expected).epsilon(1e-9));
}

TEST_CASE("emitters outside the table are hit by paths, with weight 1") {
  for (const bool nextEvent : {true, false}) {
    SceneBuilder b;
    b.material(diffuseMaterial(vec3(0.5f))).plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    b.material(diffuseMaterial(vec3(0), vec3(1))).plane({0, 0, 5}, {0, 1, 5}, {1, 0, 5});
    b.sphere({900, 0, -900}, 1);  // a light in the table, below the floor
    lookDownAt(b, 0, 0);
    render::RenderSettings settings = onePixel(16);
    settings.image.nextEventEstimation = nextEvent;
    // All directions except those below the other plane's horizon, which never hit it: the whole half-space.
    CHECK(renderScene(b.scene, settings).film.mean(0, 0).x == Approx(0.5).epsilon(1e-9));
  }
}

TEST_CASE("the image does not depend on the maximum depth once no path reaches it") {
  SceneBuilder b;
  b.material(diffuseMaterial(vec3(0.5f), vec3(0.25f))).plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  b.scene.background = {1, 2, 3};
  lookDownAt(b, 0, 0);
  CHECK(renderScene(b.scene, onePixel(4, 1)).film.mean(0, 0) == dvec3(0.25));
  CHECK(renderScene(b.scene, onePixel(4, 2)).film.mean(0, 0).z == Approx(0.25 + 1.5));
  CHECK(renderScene(b.scene, onePixel(4, 9)).film.mean(0, 0).z == Approx(0.25 + 1.5));
}

// The tree of rays: its order, its ends, and the rays that are not traced.
#include <catch2/catch.hpp>

#include "host/base/errors.h"
#include "tests/trace/reference/scene_builder.h"

using namespace candela;
using namespace candela::test;

namespace {

render::RenderSettings whittedSettings(std::uint32_t maxDepth) {
  render::RenderSettings settings = settingsOf(1, 1, 1);
  settings.image.integrator = render::Integrator::whitted;
  settings.image.maxDepth = maxDepth;
  settings.execution.recordPaths = true;
  return settings;
}

// Seen along -z: a pane of glass (primitive 0), a wall behind it (1) and one behind the camera (2).
SceneBuilder paneBetweenWalls() {
  SceneBuilder b;
  b.view({0, 0, 2}, {0, 0, 0}, {0, 1, 0}, 1e-3f);
  b.material(glassMaterial(vec3(1), 1.5f)).plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  b.material(diffuseMaterial(vec3(1), vec3(2))).plane({0, 0, -3}, {1, 0, -3}, {0, 1, -3});
  b.material(diffuseMaterial(vec3(1), vec3(10))).plane({0, 0, 5}, {1, 0, 5}, {0, 1, 5});
  return b;
}

std::vector<std::uint32_t> primitivesOf(const render::PathRecord& record) {
  std::vector<std::uint32_t> primitives;
  for (std::uint32_t i = 0; i < record.vertexCount; ++i) primitives.push_back(record.vertices[i].primitive);
  return primitives;
}

}  // namespace

TEST_CASE("a node precedes its reflected subtree, which precedes its refracted subtree") {
  const render::RenderResult result = renderScene(paneBetweenWalls().scene, whittedSettings(4));
  const render::PathRecord& record = result.paths.at(0);
  CHECK(primitivesOf(record) == std::vector<std::uint32_t>{0, 2, 1});
  CHECK(record.vertices[0].lobe == render::Lobe::refract);
  CHECK(record.vertices[1].lobe == render::Lobe::none);
  CHECK(result.film.mean(0, 0).x == Approx(0.04 * 10 + 0.96 * 2).epsilon(1e-6));
  CHECK(result.statistics.treeRays->reflected == 1);
  CHECK(result.statistics.treeRays->refracted == 1);
  CHECK(result.statistics.bounceRays == 2);
}

TEST_CASE("the camera ray has depth 1, and nodes of the maximum depth spawn no ray") {
  const render::RenderResult result = renderScene(paneBetweenWalls().scene, whittedSettings(1));
  CHECK(primitivesOf(result.paths.at(0)) == std::vector<std::uint32_t>{0});
  CHECK(result.paths.at(0).vertices[0].lobe == render::Lobe::none);
  CHECK(result.film.mean(0, 0) == dvec3(0));
  CHECK(result.statistics.bounceRays == 0);
}

TEST_CASE("glass of index 1 reflects no ray") {
  SceneBuilder b = paneBetweenWalls();
  b.scene.materials[0].whitted->ior = 1;
  const render::RenderResult result = renderScene(b.scene, whittedSettings(4));
  CHECK(primitivesOf(result.paths.at(0)) == std::vector<std::uint32_t>{0, 1});
  CHECK(result.film.mean(0, 0).x == 2);
}

TEST_CASE("a mirror's ray that would enter its own surface is not traced") {
  // The shading normal leans so far that the mirrored ray dives below the flat triangle.
  const vec3 leaning = normalize(vec3(-1, 0, 0.2f));
  SceneBuilder b;
  b.view({-2, 0, 1}, {0, 0, 0}, {0, 0, 1}, 1e-3f);
  b.material(mirrorMaterial(vec3(1)));
  b.patch({-3, -3, 0}, {3, -3, 0}, {0, 3, 0}, {{leaning, leaning, leaning}});
  const render::RenderStatistics away = renderScene(b.scene, whittedSettings(4)).statistics;
  CHECK(away.treeRays->cameraHits == 1);
  CHECK(away.treeRays->reflected == 0);
  b.scene.meshes.at(0).normals.assign(3, vec3(0, 0, 1));
  CHECK(renderScene(b.scene, whittedSettings(4)).statistics.treeRays->reflected == 1);
}

TEST_CASE("light sampling is skipped on glass that no light can illuminate") {
  SceneBuilder b = paneBetweenWalls();
  b.pointLight({1, 0, 4}, vec3(1));
  // The walls are lit, one on each side of the pane, which casts a shadow.
  const render::RenderResult result = renderScene(b.scene, whittedSettings(4));
  const render::PathRecord& record = result.paths.at(0);
  CHECK(record.vertices[0].shadow == render::ShadowOutcome::notTraced);
  CHECK(record.vertices[1].shadow == render::ShadowOutcome::visible);
  CHECK(record.vertices[1].visibleLights == 1);
  CHECK(record.vertices[2].shadow == render::ShadowOutcome::occluded);
  CHECK(record.vertices[2].visibleLights == 0);
  CHECK(result.statistics.shadowRays == 2);
}

TEST_CASE("rays are jittered with several samples per pixel, but not with one") {
  SceneBuilder b;
  b.view({0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 40);
  b.material(diffuseMaterial(vec3(0), vec3(1))).sphere({0, 0, 0}, 1);
  render::RenderSettings settings = whittedSettings(1);
  settings.image.size = {16, 16};
  settings.execution.recordPaths = false;
  std::uint64_t seeds[2];
  for (settings.image.seed = 0; settings.image.seed < 2; ++settings.image.seed)
    seeds[settings.image.seed] = renderScene(b.scene, settings).film.hash();
  CHECK(seeds[0] == seeds[1]);
  settings.image.sampleCount = 2;
  for (settings.image.seed = 0; settings.image.seed < 2; ++settings.image.seed)
    seeds[settings.image.seed] = renderScene(b.scene, settings).film.hash();
  CHECK(seeds[0] != seeds[1]);
}

TEST_CASE("lights and materials that Whitted ray tracing does not have are refused") {
  scene::Scene lit = paneBetweenWalls().scene;
  lit.punctualLights.push_back({.position = {0, 0, 1}});
  CHECK_THROWS_WITH(renderScene(lit, whittedSettings(4)), Catch::Contains("lights with fall-off, spot lights or"));
  scene::Scene plain = paneBetweenWalls().scene;
  plain.materials[1].whitted.reset();
  CHECK_THROWS_AS(renderScene(plain, whittedSettings(4)), UsageError);
  CHECK_THROWS_WITH(renderScene(plain, whittedSettings(4)), Catch::Contains("no coefficients for Whitted ray tracing"));
  CHECK_NOTHROW(renderScene(plain, settingsOf(1, 1, 1)));
}

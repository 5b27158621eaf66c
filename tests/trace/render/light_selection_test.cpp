// How lights are chosen by default.
#include "host/trace/render/light_selection.h"

#include <catch2/catch.hpp>

#include "host/trace/render/request.h"
#include "tests/trace/reference/scene_builder.h"

using namespace candela;
using glm::vec3;
using render::LightSelection;
using test::SceneBuilder;

namespace {

// Spheres in a row beside the origin, and a floor.
scene::Scene row(std::size_t lamps, float distance = 1) {
  SceneBuilder b;
  b.material(test::diffuseMaterial(vec3(1), vec3(1)));
  for (std::size_t i = 0; i < lamps; ++i) b.sphere({distance, 0, 0.1f * static_cast<float>(i)}, 0.02f);
  b.material(test::diffuseMaterial(vec3(1))).quad({-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1});
  return b.scene;
}

}  // namespace

TEST_CASE("lights are chosen by a tree from 24 lights on, and by power below") {
  CHECK(render::selectionFor(row(23)) == LightSelection::power);
  CHECK(render::selectionFor(row(24)) == LightSelection::tree);
  CHECK(render::selectionFor({}) == LightSelection::power);
}

TEST_CASE("of lights that are no emitters, only point and spot lights with fall-off count for a light tree") {
  scene::Scene scene = row(20);
  scene.pointLights.resize(50);
  scene.punctualLights.resize(50, {.kind = scene::PunctualLight::Kind::directional});
  CHECK(render::selectionFor(scene) == LightSelection::power);
  for (int i = 0; i < 4; ++i) {
    scene.punctualLights[i].kind = i % 2 == 0 ? scene::PunctualLight::Kind::point : scene::PunctualLight::Kind::spot;
  }
  CHECK(render::selectionFor(scene) == LightSelection::tree);
}

TEST_CASE("lights that are far from everything else are chosen by power") {
  CHECK(render::selectionFor(row(30, 100)) == LightSelection::power);
  CHECK(render::selectionFor(row(30, 10)) == LightSelection::tree);
}

TEST_CASE("a request's choice of lights precedes the scene's, and other integrators have none") {
  const scene::Scene scene = row(30);
  scene::Scene seen = scene;
  seen.camera.emplace();
  render::RenderRequest request;
  CHECK(resolve(request, seen).image.lights == LightSelection::tree);
  request.image.integrator = render::Integrator::ao;
  CHECK(resolve(request, seen).image.lights == LightSelection::power);
  request.image.integrator = render::Integrator::path;
  request.lights = LightSelection::power;
  CHECK(resolve(request, seen).image.lights == LightSelection::power);
}

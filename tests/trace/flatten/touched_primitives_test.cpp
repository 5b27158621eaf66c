// The marks of primitives that may contain a light, and the overlap of polygons.
#include "host/trace/flatten/touched_primitives.h"

#include <array>
#include <catch2/catch.hpp>

#include "host/trace/flatten/flat_scene.h"
#include "host/trace/flatten/overlap.h"
#include "shaders/shared/scene_rows.h"
#include "tests/trace/reference/touching_lights.h"

using namespace candela;
using glm::dvec3;
using glm::vec3;
using test::SceneBuilder;
using test::Shifted;

namespace {

// Indices of the marked primitives.
std::vector<std::uint32_t> touchedIn(const scene::Scene& scene, const render::ImageSettings& image = {}) {
  const std::vector<flatten::LightEntry> table = flatten::buildLightTable(scene, image.nextEventEstimation).entries;
  const std::vector<bool> touched = touchedPrimitives(scene, lightPositions(scene, table, image));
  std::vector<std::uint32_t> result;
  for (std::uint32_t i = 0; i < touched.size(); ++i) {
    if (touched[i]) result.push_back(i);
  }
  return result;
}

using Indices = std::vector<std::uint32_t>;

}  // namespace

TEST_CASE("every surface that a light touches is marked, and the flat scene has the mark and the feature") {
  for (const vec3& shift : {vec3(0), vec3(100000, -100000, 100000)}) {
    for (const test::TouchedSurface& surface : test::touchedSurfaces()) {
      CAPTURE(surface.name, shift.x);
      SceneBuilder b = test::floorUnder(shift);
      surface.add({b, shift});
      b.pointLight(surface.light + shift, vec3(1));
      CHECK_FALSE(touchedIn(b.scene).empty());
      const flatten::FlatScene flat = flatten::flattenScene(b.scene, test::settingsOf(8, 8, 1));
      CHECK(flat.shape.features.touched);
      std::size_t marks = 0;
      for (std::uint32_t slot = 0; slot < flat.shape.slotCount; ++slot) {
        const std::uint32_t row = flat.constants.firstPrimitiveRow + slot * gpu::kPrimitiveRows;
        marks += (flat.rows[row + 2].w & gpu::kFlagTouched) != 0;
      }
      CHECK(marks == touchedIn(b.scene).size());
      b.scene.pointLights[0].position = surface.light + shift - 8 * test::marginNear(shift) * normalize(surface.inward);
      // At 10^5, this is near the floor; the host does not know which part of a huge sphere the camera sees.
      if (shift == vec3(0) && surface.name != "a huge sphere") CHECK(touchedIn(b.scene).empty());
    }
  }
}

TEST_CASE("only the walls in whose planes the light lies are marked") {
  SceneBuilder b = test::floorUnder(vec3(0));  // primitives 0 and 1
  const Shifted here{b, vec3(0)};
  test::addWallInX(here), test::addWallInY(here), test::addCeiling(here);  // 2 to 7
  b.pointLight({1, 1, 1}, vec3(1)).pointLight({-4, 1, 4}, vec3(1));
  CHECK(touchedIn(b.scene) == Indices{2, 3, 6, 7});
  b.scene.pointLights.pop_back();
  CHECK(touchedIn(b.scene).empty());
}

TEST_CASE("a light touches a box on each of its six faces, and not behind or within it") {
  const vec3 low(-1, -2, -3), high(2, 4, 6), centre = 0.5f * (low + high);
  for (int axis = 0; axis < 3; ++axis) {
    for (const float face : {low[axis], high[axis]}) {
      SceneBuilder b;
      b.material(test::diffuseMaterial(vec3(1))).box(low, high);
      vec3 light = centre;
      light[axis] = face;
      CAPTURE(axis, face);
      b.pointLight(light, vec3(1));
      CHECK(touchedIn(b.scene) == Indices{0});
      b.scene.pointLights[0].position[axis] = centre[axis] + 1.01f * (face - centre[axis]);
      CHECK(touchedIn(b.scene).empty());
      b.scene.pointLights[0].position[axis] = centre[axis] + 0.99f * (face - centre[axis]);
      CHECK(touchedIn(b.scene).empty());
    }
  }
}

TEST_CASE("an area light marks what it overlaps, and not its neighbours") {
  SceneBuilder b = test::floorUnder(vec3(0));
  b.material(test::diffuseMaterial(vec3(0), vec3(1))).quad({0, 0, 4}, {1, 0, 4}, {1, 1, 4}, {0, 1, 4});  // 2 and 3
  b.material(test::diffuseMaterial(vec3(1)));
  b.quad({1, 0, 4}, {2, 0, 4}, {2, 1, 4}, {1, 1, 4});  // beside the light
  b.triangle({0, 0, 4}, {1, 0, 4}, {0, 0, 8});         // on its edge
  CHECK(touchedIn(b.scene).empty());
  b.triangle({-1, -1, 4}, {-1, 9, 4}, {9, -1, 4});    // 7, around it
  b.triangle({0.5f, 0.5f, 4}, {3, 3, 4}, {3, 2, 4});  // 8, over a corner
  b.box({-2, -2, 4}, {2, 2, 5}).plane({0, 0, 4}, {1, 0, 4}, {0, 1, 4});
  b.plane({0, 0, 4}, {1, 0, 4.01f}, {0, 1, 4});
  CHECK(touchedIn(b.scene) == Indices{7, 8, 9, 10});
  render::ImageSettings withoutLightSampling;
  withoutLightSampling.nextEventEstimation = false;
  CHECK(touchedIn(b.scene, withoutLightSampling).empty());
}

TEST_CASE("views have no lights, and squares of the Whitted tracer reach beyond their positions") {
  SceneBuilder b = test::floorUnder(vec3(0));
  test::addWallInY({b, vec3(0)});
  b.pointLight({0, -3.5f, 2}, vec3(1));
  render::ImageSettings image;
  image.integrator = render::Integrator::whitted;
  CHECK(touchedIn(b.scene, image).empty());
  image.lightSize = 0.75f;
  CHECK(touchedIn(b.scene, image) == Indices{2, 3});
  b.scene.pointLights[0].position.y = -4;
  image.integrator = render::Integrator::ao;
  CHECK(touchedIn(b.scene, image).empty());
}

TEST_CASE("with too many pairs of lights and primitives, all primitives are marked") {
  SceneBuilder b = test::floorUnder(vec3(0));
  for (int i = 0; i < 6000; ++i) {
    b.sphere({0, 0, 9}, 1);
    b.pointLight({0, 0, 5}, vec3(1));
  }
  CHECK(touchedIn(b.scene).size() == 6002);
}

TEST_CASE("polygons overlap if their interiors do") {
  const std::array<dvec3, 3> triangle{{{0, 0, 7}, {3, 0, 7}, {0, 3, 7}}};
  const dvec3 up(0.1, -0.2, 1);
  const auto overlaps = [&](const std::vector<dvec3>& other) {
    CHECK(flatten::overlap(triangle, other, up) == flatten::overlap(other, triangle, up));
    return flatten::overlap(triangle, other, up);
  };
  CHECK(overlaps({{0, 0, 7}, {3, 0, 7}, {0, 3, 7}}));
  CHECK(overlaps({{-9, -9, 7}, {9, -9, 7}, {9, 9, 7}, {-9, 9, 7}}));
  CHECK(overlaps({{0.1, 0.1, 7}, {0.2, 0.1, 7}, {0.1, 0.2, 7}}));
  CHECK(overlaps({{1.4, 1.4, 7}, {5, 5, 7}, {5, 4, 7}}));
  CHECK_FALSE(overlaps({{1.6, 1.6, 7}, {5, 5, 7}, {5, 4, 7}}));
  CHECK_FALSE(overlaps({{3, 0, 7}, {3, 3, 7}, {0, 3, 7}}));     // shares an edge
  CHECK_FALSE(overlaps({{1, 0, 7}, {2, 0, 7}, {2, -1, 7}}));    // touches an edge
  CHECK_FALSE(overlaps({{-1, -1, 7}, {0, -1, 7}, {0, 0, 7}}));  // shares a vertex
  CHECK_FALSE(flatten::overlap(triangle, std::vector<dvec3>{{1, 9, 1}, {2, 9, 1}, {1, 9, 2}}, dvec3(0, 0, 1)));
}

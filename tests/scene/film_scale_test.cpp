// The scale of films by the lights of a scene.
#include "host/scene/film_scale.h"

#include <catch2/catch.hpp>
#include <limits>
#include <numbers>

#include "tests/trace/reference/scene_builder.h"

using namespace candela;
using namespace candela::scene;
using glm::vec3;
using test::SceneBuilder;

namespace {

using Kind = PunctualLight::Kind;

// A square whose diagonal is 4, so that its squared radius is 4.
SceneBuilder square() {
  SceneBuilder b;
  const float half = std::numbers::sqrt2_v<float>;
  b.material(test::diffuseMaterial(vec3(0.5f)))
      .quad({-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0});
  return b;
}

std::uint32_t scaleUnder(const std::vector<PunctualLight>& lights) {
  SceneBuilder b = square();
  b.scene.punctualLights = lights;
  return filmScaleOf(b.scene);
}

std::uint32_t scaleUnderSun(float irradiance) {
  return scaleUnder({{.kind = Kind::directional, .intensity = {irradiance, 0.5f * irradiance, 0}}});
}

std::uint32_t scaleOfEmission(float radiance) {
  SceneBuilder b = square();
  b.material(test::diffuseMaterial(vec3(0), vec3(1, radiance, 1))).sphere({0, 0, 0}, 1);
  return filmScaleOf(b.scene);
}

}  // namespace

TEST_CASE("weak lights need no scale, and strong ones are brought to an irradiance of at most 1") {
  CHECK(scaleUnder({}) == 0);
  CHECK(scaleUnderSun(3.14159f) == 0);
  CHECK(scaleUnderSun(64) == 0);
  CHECK(scaleUnderSun(64.001f) == 7);
  CHECK(scaleUnderSun(128) == 7);
  CHECK(scaleUnderSun(128.001f) == 8);
  CHECK(scaleUnderSun(1e5f) == 17);
  CHECK(scaleUnderSun(1e6f) == 20);
  CHECK(scaleUnderSun(std::numeric_limits<float>::max()) == image::kMaxFilmScale);
}

TEST_CASE("lights add up, and those with fall-off count by their irradiance at the radius of the scene") {
  const PunctualLight sun{.kind = Kind::directional, .intensity = vec3(50)};
  const PunctualLight lamp{.kind = Kind::point, .position = {0, 0, 1e6f}, .intensity = vec3(200)};  // 50 at 2
  const PunctualLight spot{.kind = Kind::spot, .intensity = vec3(240)};                             // 60 at 2
  CHECK(scaleUnder({sun}) == 0);
  CHECK(scaleUnder({lamp}) == 0);
  CHECK(scaleUnder({sun, lamp}) == 7);
  CHECK(scaleUnder({lamp, spot}) == 7);
  CHECK(scaleUnder({sun, lamp, spot}) == 8);
  SceneBuilder b = square();
  b.scene.pointLights = {{.position = {0, 0, 1}, .colour = {0, 0, 20}}};
  CHECK(filmScaleOf(b.scene) == 0);
  b.scene.pointLights.push_back({.position = {0, 0, 1}, .colour = {1, 0, 0}});  // 21 pi
  CHECK(filmScaleOf(b.scene) == 7);
}

TEST_CASE("a lamp over a plane without bounds counts by its intensity") {
  SceneBuilder b;
  b.material(test::diffuseMaterial(vec3(0.5f))).plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  b.scene.punctualLights = {{.kind = Kind::point, .intensity = vec3(65)}};
  CHECK(filmScaleOf(b.scene) == 7);
}

TEST_CASE("radiances that a film can represent need no scale, and larger ones are brought to at most 2^17") {
  CHECK(scaleOfEmission(1e6f) == 0);
  CHECK(scaleOfEmission(0x1p20f) == 0);
  CHECK(scaleOfEmission(0x1.000002p20f) == 4);
  CHECK(scaleOfEmission(0x1p24f) == 7);
  CHECK(scaleOfEmission(1e30f) == image::kMaxFilmScale);
}

TEST_CASE("the background counts unless an environment replaces it") {
  SceneBuilder b = square();
  b.scene.background = {0, 0, 0x1p22f};
  CHECK(filmScaleOf(b.scene) == 5);
  b.scene.environment.emplace();
  b.scene.environment->texels = {vec3(1), vec3(7)};
  CHECK(filmScaleOf(b.scene) == 0);
  b.scene.environment->texels.push_back({0, 0x1p25f, 0});
  CHECK(filmScaleOf(b.scene) == 8);
}

TEST_CASE("the larger scale of lights with and without extent is chosen") {
  SceneBuilder b = square();
  b.scene.background = vec3(0x1p22f);
  b.scene.punctualLights = {{.kind = Kind::directional, .intensity = vec3(128)}};
  CHECK(filmScaleOf(b.scene) == 7);
}

// Light with closed forms: lights over a diffuse floor, among them a point light, and furnaces.
#include <catch2/catch.hpp>

#include "tests/trace/proof/closed_meshes.h"
#include "tests/trace/proof/leaves.h"
#include "tests/trace/reference/scene_builder.h"

using namespace candela;
using namespace candela::proof;
using glm::vec3;
using test::diffuseMaterial;
using test::SceneBuilder;

namespace {

constexpr float kAlbedo = 0.75f;

const scene::Sphere kBall{{-1, 0.5f, 2}, 0.5f};
const vec3 kNear[3] = {{1, -0.5f, 1}, {1.5f, 1, 1.25f}, {0.75f, 0.25f, 2}};
const vec3 kFar[3] = {{2, 3, 4}, {-2, 4, 3}, {0, 2.5f, 4.5f}};

// A red ball, a green triangle, a blue one farther away, so that each has a separate channel; and a grey point light.
scene::Scene lampsOverFloor(const vec3& seen) {
  SceneBuilder b;
  b.material(diffuseMaterial(vec3(kAlbedo))).plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  b.material(diffuseMaterial(vec3(0), {5, 0, 0})).sphere(kBall.centre, kBall.radius);
  b.material(diffuseMaterial(vec3(0), {0, 3, 0})).triangle(kNear[0], kNear[1], kNear[2]);
  b.material(diffuseMaterial(vec3(0), {0, 0, 8})).triangle(kFar[0], kFar[1], kFar[2]);
  b.pointLight({0, -4, 3}, vec3(0.125f));
  b.view(seen + vec3(0, -1.5f, 2), seen, {0, 1, 0}, 1e-3f);
  return b.scene;
}

// A red point light with fall-off, a green spot light whose axis passes beside the visible point, and a blue sun.
scene::Scene punctualLightsOverFloor() {
  using Kind = scene::PunctualLight::Kind;
  SceneBuilder b;
  b.material(diffuseMaterial(vec3(kAlbedo))).plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  b.scene.punctualLights = {
      {.kind = Kind::point, .position = {1, 0, 2}, .intensity = {20, 0, 0}},
      {.kind = Kind::spot,
       .position = {0, 0, 4},
       .direction = {0.6f, 0, -0.8f},
       .intensity = {0, 300, 0},
       .versineInner = 0.1f,
       .versineOuter = 0.3f},
      {.kind = Kind::directional, .direction = {0, 0.6f, -0.8f}, .intensity = {0, 0, 5}, .reach = 4}};
  b.view({0, -1.5f, 2}, {0, 0, 0}, {0, 1, 0}, 1e-3f);
  return b.scene;
}

float versine(double angle) { return static_cast<float>(2 * std::pow(std::sin(angle / 2), 2)); }

// A spot light 10 above the visible point, which is at `angle` from its direction.
scene::PunctualLight narrowSpot(double angle, double inner, double outer, const vec3& intensity) {
  return {.kind = scene::PunctualLight::Kind::spot,
          .position = {0, 0, 10},
          .direction = vec3(dvec3(std::sin(angle), 0, -std::cos(angle))),
          .intensity = intensity,
          .versineInner = versine(inner),
          .versineOuter = versine(outer)};
}

// Lambert's formula for the irradiance of a polygon of radiance 1 above the horizon.
double irradianceOfTriangle(const vec3 (&corners)[3], const dvec3& at) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    const dvec3 a = normalize(dvec3(corners[i]) - at), b = normalize(dvec3(corners[(i + 1) % 3]) - at);
    sum += std::acos(dot(a, b)) * normalize(cross(a, b)).z / 2;
  }
  return std::abs(sum);
}

// A sphere above the horizon lights like a point at its centre: E = pi (R / D)^2 cos.
double irradianceOfBall(const dvec3& at) {
  const dvec3 towards = dvec3(kBall.centre) - at;
  return std::numbers::pi * kBall.radius * kBall.radius * towards.z / std::pow(length(towards), 3);
}

render::RenderSettings withoutRoulette(std::uint32_t side, std::uint32_t samples) {
  render::RenderSettings settings = test::settingsOf(side, side, samples);
  settings.image.maxDepth = 64;
  settings.image.rouletteStart = 64;
  return settings;
}

}  // namespace

TEST_CASE("a sphere, two triangles and a point light illuminate the floor by their closed forms, each in its channel",
          "[swiftshader-slow]") {
  for (const vec3& seen : {vec3(0), vec3(0.25f, -0.5f, 0)}) {  // points from which no light occludes another
    const dvec3 at(seen);
    const dvec3 towardsPoint = dvec3(0, -4, 3) - at;
    const dvec3 expected = double{kAlbedo} / std::numbers::pi *
                               dvec3(5 * irradianceOfBall(at), 3 * irradianceOfTriangle(kNear, at),
                                     8 * irradianceOfTriangle(kFar, at)) +
                           kAlbedo * 0.125 * towardsPoint.z / length(towardsPoint);
    render::RenderSettings settings = withoutRoulette(16, 4096);
    settings.image.maxDepth = 2;
    const dvec3 shown = test::meanOf(renderScene(lampsOverFloor(seen), settings).film);
    CAPTURE(seen.x);
    for (int channel = 0; channel < 3; ++channel) {
      CAPTURE(channel);
      CHECK(shown[channel] == Approx(expected[channel]).epsilon(2e-3));
    }
  }
}

TEST_CASE("lights with fall-off, spot lights and directional lights light the floor by their closed forms",
          "[swiftshader-slow]") {
  const double spot = (0.8 - 0.7) / (0.9 - 0.7);  // the place is at cosine 0.8 from the spot's direction
  const dvec3 irradiance(20 / 5.0 * (2 / std::sqrt(5.0)), 300 / 16.0 * spot * spot, 5 * 0.8);
  const dvec3 expected = double{kAlbedo} / std::numbers::pi * irradiance;
  render::RenderSettings settings = withoutRoulette(16, 4096);
  settings.image.maxDepth = 2;
  for (const bool nextEventEstimation : {true, false}) {  // no ray finds these lights, so that they are always sampled
    settings.image.nextEventEstimation = nextEventEstimation;
    const dvec3 shown = test::meanOf(renderScene(punctualLightsOverFloor(), settings).film);
    for (int channel = 0; channel < 3; ++channel) {
      CAPTURE(channel, nextEventEstimation);
      CHECK(shown[channel] == Approx(expected[channel]).epsilon(2e-3));
    }
  }
}

TEST_CASE("narrow spot lights have their full intensity inside the inner cone, and fall off between the cones") {
  SceneBuilder b;
  b.material(diffuseMaterial(vec3(kAlbedo))).plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  b.view({0, -1.5f, 2}, {0, 0, 0}, {0, 1, 0}, 1e-3f);
  b.scene.punctualLights = {narrowSpot(0.005, 0.01, 0.02, {300, 0, 0}), narrowSpot(0.0015, 0.001, 0.002, {0, 90, 0}),
                            narrowSpot(7e-4, 5e-4, 1e-3, {0, 0, 900}), narrowSpot(0.0021, 0.001, 0.002, {99, 99, 99})};
  const auto inside = [](double angle, double inner, double outer) {
    const double fraction = (std::cos(angle) - std::cos(outer)) / (std::cos(inner) - std::cos(outer));
    return fraction * fraction;
  };
  const dvec3 expected = kAlbedo / std::numbers::pi *
                         dvec3(3, 0.9 * inside(0.0015, 1e-3, 2e-3), 9 * inside(7e-4, 5e-4, 1e-3));
  render::RenderSettings settings = withoutRoulette(16, 4096);
  settings.image.maxDepth = 2;
  const dvec3 shown = test::meanOf(renderScene(b.scene, settings).film);
  for (int channel = 0; channel < 3; ++channel) {
    CAPTURE(channel);
    CHECK(shown[channel] == Approx(expected[channel]).epsilon(3e-3));
  }
}

TEST_CASE("furnaces made of a mesh with coplanar neighbours show 1 / (1 - albedo), with and without roulette",
          "[swiftshader-slow]") {
  for (const float albedo : {0.25f, 0.5f, 0.75f}) {
    scene::Scene furnace = boxMesh(1, 4).scene();
    furnace.materials[0] = diffuseMaterial(vec3(albedo), vec3(1));
    furnace.camera->from = {0.25f, 0.1f, 0.3f};
    furnace.camera->at = {-1, 0.5f, -1};
    const double expected = 1 / (1 - double{albedo});
    CAPTURE(albedo);
    render::RenderSettings settings = withoutRoulette(16, 16);
    settings.image.nextEventEstimation = false;
    CHECK(test::meanOf(renderScene(furnace, settings).film).y == Approx(expected).epsilon(1e-6 + kRounding));
    settings = test::settingsOf(32, 32, 256);
    settings.image.nextEventEstimation = false;
    settings.image.rouletteStart = 1;
    // A path's length is geometric: its deviation is sqrt(albedo) / (1 - albedo), of 2^18 paths.
    const double error = std::sqrt(double{albedo}) * expected / 512;
    CHECK(std::abs(test::meanOf(renderScene(furnace, settings).film).y - expected) < 4 * error);
  }
}

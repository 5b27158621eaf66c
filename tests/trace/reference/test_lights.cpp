// The thresholds of the light table, compared with values computed by hand, and the sampling of lights with its
// densities.
#include <catch2/catch.hpp>
#include <cmath>

#include "host/trace/reference/arithmetic.h"
#include "host/trace/reference/lights.h"
#include "host/trace/reference/sampling.h"
#include "host/trace/reference/tracing.h"
#include "tests/trace/reference/default_settings.h"
#include "tests/trace/reference/scene_builder.h"

using namespace candela;
using namespace candela::reference;
using glm::vec3;
using test::diffuseMaterial;
using test::SceneBuilder;

namespace {

using Thresholds = std::vector<std::uint32_t>;

constexpr std::uint32_t kAll = 1u << 24;

Surface surfaceFacing(const dvec3& position, const dvec3& normal, std::uint32_t primitive = kNoPrimitive) {
  return {position, normal, normal, normal, true, primitive, 0};
}

// Mean over light samples of g(sample) / pdf.
template <class Function>
double estimate(const LightTable& lights, const Surface& surface, const Function& g) {
  constexpr int kSide = 300;
  double sum = 0;
  for (int i = 0; i < kSide * kSide; ++i) {
    const auto sample = lights.sample(lights.choiceOf(0), surface,
                                      {(i % kSide + 0.5) / kSide, (i / kSide + 0.5) / kSide});
    if (sample) sum += g(*sample) / *sample->pdf;
  }
  return sum / (kSide * kSide);
}

render::RenderSettings settingsWith(bool nextEvent, bool oneSided = false) {
  render::RenderSettings settings = render::defaultSettings();
  settings.image.nextEventEstimation = nextEvent;
  settings.image.oneSided = oneSided;
  return settings;
}

}  // namespace

TEST_CASE("triangles share the table by area and luminance") {
  SceneBuilder b;
  b.material(diffuseMaterial(vec3(1), vec3(1)));
  b.triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});  // 1/2
  b.triangle({0, 0, 0}, {1, 0, 0}, {2, 0, 0});  // no area: not in the table
  b.material(diffuseMaterial(vec3(1))).triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  b.material(diffuseMaterial(vec3(1), vec3(3))).triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});  // 3/2
  const LightTable lights(b.scene, render::defaultSettings());
  CHECK(lights.thresholds() == Thresholds{kAll / 4, kAll});
  CHECK(lights.choose(0).entry == 0);
  CHECK(lights.choose((kAll / 4 - 1) << 8 | 0xff).entry == 0);
  CHECK(lights.choose((kAll / 4) << 8).entry == 1);
  CHECK(lights.choose(~0u).entry == 1);
  CHECK(lights.choose(~0u).probability == 0.75);
}

TEST_CASE("thresholds are rounded to nearest, and the last one is 2^24") {
  SceneBuilder b;
  b.pointLight({0, 0, 1}, vec3(1)).pointLight({0, 0, 1}, vec3(1)).pointLight({0, 0, 1}, vec3(1));
  // 2^24 / 3 = 5592405.33, 2 * 2^24 / 3 = 11184810.67.
  CHECK(LightTable(b.scene, render::defaultSettings()).thresholds() == Thresholds{5592405, 11184811, kAll});
}

TEST_CASE("lights that no ray finds have at least a fifth of the mean weight, however bright another one is") {
  SceneBuilder b;
  b.pointLight({0, 0, 1}, vec3(1e-6f)).pointLight({0, 0, 2}, vec3(0)).pointLight({0, 0, 3}, vec3(1));
  b.scene.punctualLights.resize(2);
  b.scene.punctualLights[0].intensity = vec3(1e-3f);
  b.scene.punctualLights[1].intensity = vec3(3);
  const LightTable lights(b.scene, render::defaultSettings());
  // Four lights are on, so that two weights are raised to 4/20: 0.2, 0, 1, 0.2, 3 of 4.4.
  const double expected[] = {1 / 22.0, 1 / 22.0, 6 / 22.0, 7 / 22.0, 1};
  for (std::size_t i = 0; i < 5; ++i) CHECK(lights.thresholds().at(i) == Approx(expected[i] * kAll).epsilon(1e-3));
}

TEST_CASE("emitters, point lights and the environment are chosen by the flux that the scene receives") {
  SceneBuilder b;
  b.material(diffuseMaterial(vec3(1), vec3(5))).sphere({0, 0, 0}, 1).sphere({5, 0, 0}, 1);
  b.pointLight({0, 0, 3}, vec3(0.5f));
  // The box of the spheres is 7 by 2 by 2, so that R^2 = 57/4. Divided by pi: 40 pi, pi R^2 / 2, and 4 R^2 * 0.25.
  const double emitters = 40 * kPi, points = kPi * 57 / 8;
  const double both = 0.2 + 0.6 * emitters / (emitters + points);
  const Thresholds two = LightTable(b.scene, render::defaultSettings()).thresholds();
  CHECK(two[0] == Approx(both / 2 * kAll).margin(1));
  CHECK(two[1] == Approx(both * kAll).margin(1));
  b.scene.environment = scene::Environment{.name = "", .width = 2, .height = 2, .texels = {}, .weights = {}};
  b.scene.environment->texels.assign(4, vec3(0.25f));
  b.scene.environment->weights.assign(4, scene::Environment::kMeanWeight);
  const Thresholds three = LightTable(b.scene, render::defaultSettings()).thresholds();
  const double sum = emitters + points + 57 * 0.25;
  CHECK(three[1] == Approx((0.2 + 0.4 * emitters / sum) * kAll).margin(1));
  CHECK(three[2] == Approx((0.4 + 0.4 * (emitters + points) / sum) * kAll).margin(1));
  CHECK(three[3] == kAll);
}

TEST_CASE("lights of weight 0 stay in the table and are never chosen") {
  SceneBuilder b;
  b.pointLight({0, 0, 1}, vec3(0)).pointLight({0, 0, 1}, vec3(1)).pointLight({0, 0, 1}, vec3(0));
  const LightTable lights(b.scene, render::defaultSettings());
  CHECK(lights.thresholds() == Thresholds{0, kAll, kAll});
  CHECK(lights.choose(0).entry == 1);
  CHECK(lights.choose(~0u).entry == 1);

  SceneBuilder dark;
  dark.pointLight({0, 0, 1}, vec3(0));
  CHECK_FALSE(LightTable(dark.scene, render::defaultSettings()).canChoose());
}

TEST_CASE("only point lights are in the table without next-event estimation") {
  SceneBuilder b;
  b.material(diffuseMaterial(vec3(1), vec3(5))).sphere({0, 0, 0}, 1);
  CHECK_FALSE(LightTable(b.scene, settingsWith(false)).canChoose());
  b.pointLight({0, 0, 3}, vec3(1));
  CHECK(LightTable(b.scene, settingsWith(false)).thresholds() == Thresholds{kAll});
}

TEST_CASE("boxes, cones and planes that emit are not in the table") {
  SceneBuilder b;
  b.material(diffuseMaterial(vec3(1), vec3(5)));
  b.box({0, 0, 0}, {1, 1, 1}).cone({0, 0, 0}, 1, {0, 0, 1}, 1).plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  CHECK_FALSE(LightTable(b.scene, render::defaultSettings()).canChoose());
}

TEST_CASE("sphere samples give the irradiance of a sphere, outside and inside") {
  SceneBuilder b;
  b.material(diffuseMaterial(vec3(1), vec3(1))).sphere({0, 0, 3}, 1);
  const LightTable lights(b.scene, render::defaultSettings());
  const dvec3 up(0, 0, 1);
  const auto cosine = [&](const LightSample& sample) { return std::max(0.0, dot(sample.wi, up)); };
  CHECK(estimate(lights, surfaceFacing({0, 0, 0}, up), cosine) == Approx(kPi / 9).epsilon(1e-4));
  // From (3, 0, 0): distance^2 18, cosine 1/sqrt 2.
  CHECK(estimate(lights, surfaceFacing({3, 0, 0}, up), cosine) == Approx(kPi / 18 / std::sqrt(2)).epsilon(1e-4));
  CHECK(estimate(lights, surfaceFacing({0, 0.3, 3}, up), cosine) == Approx(kPi).epsilon(1e-3));
  // On the inside of the sphere, looking to the centre: everything above the horizon is lit.
  CHECK(estimate(lights, surfaceFacing({0, 0, 2}, up, 0), cosine) == Approx(kPi).epsilon(1e-3));
}

TEST_CASE("triangle samples give the form factor of a triangle") {
  SceneBuilder b;
  b.material(diffuseMaterial(vec3(1), vec3(1))).triangle({0, 0, 1}, {0, 1, 1}, {1, 0, 1});
  const LightTable lights(b.scene, render::defaultSettings());
  const dvec3 up(0, 0, 1), corners[3] = {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
  // Lambert's formula: half the sum over the edges of the angle times the cosine to the edge's normal.
  double expected = 0;
  for (int i = 0; i < 3; ++i) {
    const dvec3 a = normalize(corners[i]), c = normalize(corners[(i + 1) % 3]);
    expected += std::acos(dot(a, c)) * dot(normalize(cross(a, c)), up) / 2;
  }
  const double found = estimate(lights, surfaceFacing({0, 0, 0}, up), [](const LightSample& s) { return s.wi.z; });
  CHECK(found == Approx(expected).epsilon(1e-4));
}

TEST_CASE("the density of a hit is the density with which it is sampled") {
  Arithmetic exact;
  SceneBuilder b;
  b.material(diffuseMaterial(vec3(1), vec3(1)));
  b.sphere({0, 0, 3}, 1).sphere({0, 0, 0}, -5).triangle({1, 0, 1}, {1, 1, 1}, {2, 0, 1});
  const LightTable lights(b.scene, render::defaultSettings());
  Counters counters;
  for (std::uint32_t entry = 0; entry < 3; ++entry) {
    const Surface from = surfaceFacing({0.2, 0.1, 0}, {0, 0, 1});
    const auto sample = lights.sample(lights.choiceOf(entry), from, {0.3, 0.6});
    REQUIRE(sample);
    CHECK(sample->primitive == entry);
    const Ray ray{from.position, sample->wi};
    scene::Scene alone = b.scene;
    alone.primitives = {b.scene.primitives[entry]};
    const Hit hit = Tracing(alone, render::defaultSettings()).closest(ray, counters);
    REQUIRE(hit);
    CHECK(hit.distance == Approx(sample->distance));
    const double share = (lights.thresholds()[entry] - (entry > 0 ? lights.thresholds()[entry - 1] : 0)) / double{kAll};
    const Surface lit = surfaceAt(b.scene, ray, {hit.distance, entry});
    CHECK(lights.pdf(ray, hit.distance, lit, {}, exact) == Approx(share * *sample->pdf));
  }
}

TEST_CASE("a triangle light does not illuminate itself and, with --one-sided, nothing behind it") {
  SceneBuilder b;
  b.material(diffuseMaterial(vec3(1), vec3(1))).triangle({0, 0, 1}, {1, 0, 1}, {0, 1, 1});  // front towards +z
  const LightTable twoSided(b.scene, render::defaultSettings()), oneSided(b.scene, settingsWith(true, true));
  const Surface below = surfaceFacing({0, 0, 0}, {0, 0, 1}), above = surfaceFacing({0, 0, 2}, {0, 0, -1});
  CHECK(twoSided.sample(twoSided.choiceOf(0), below, {0.5, 0.5}));
  CHECK_FALSE(oneSided.sample(oneSided.choiceOf(0), below, {0.5, 0.5}));
  CHECK(oneSided.sample(oneSided.choiceOf(0), above, {0.5, 0.5}));
  CHECK_FALSE(twoSided.sample(twoSided.choiceOf(0), surfaceFacing({0.2, 0.2, 1}, {0, 0, 1}, 0), {0.5, 0.5}));
  CHECK_FALSE(twoSided.sample(twoSided.choiceOf(0), surfaceFacing({5, 5, 1}, {0, 0, 1}), {0.5, 0.5}));  // edge on
}

TEST_CASE("a background that is no environment has no entry") {
  SceneBuilder b;
  b.scene.background = vec3(1);
  const LightTable lights(b.scene, render::defaultSettings());
  CHECK(lights.thresholds().empty());
  CHECK(lights.environmentProbability() == 0);
}

TEST_CASE("every kind of light has the documented power") {
  const dvec3 white(1);
  CHECK(SphereLight({vec3(0), -2}, white, 0).power() == Approx(16 * kPi));
  CHECK(TriangleLight({{vec3(0), vec3(2, 0, 0), vec3(0, 3, 0)}}, white, 0, false).power() == Approx(3));
  CHECK(PointLight({vec3(0), vec3(5)}).power() == Approx(5));
  CHECK(EnvironmentLight(false).power() == 0);
  CHECK(EnvironmentLight(true).power() == 1);
}

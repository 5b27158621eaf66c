// Lights that touch surfaces are hidden neither by them nor by rounding; lights behind surfaces are hidden.
#include <catch2/catch.hpp>
#include <random>
#include <utility>

#include "host/trace/reference/rounding/rounded_arithmetic.h"
#include "tests/trace/reference/default_settings.h"
#include "tests/trace/reference/touching_lights.h"

using namespace candela;
using namespace candela::reference;
using glm::vec3;
using test::SceneBuilder;
using test::Shifted;

namespace {

// Counts the occluded shadow rays from points of the floor to the light.
class ShadowRays {
 public:
  ShadowRays(scene::Scene scene, const vec3& shift, std::uint32_t replicas = 0)
      : scene_(std::move(scene)), shift_(shift) {
    render::RenderSettings settings = render::defaultSettings();
    settings.execution.replicas = replicas;
    tracing_.emplace(scene_, settings);
    rounded_.emplace(scene_, *tracing_, dvec3(scene_.camera->from));
  }

  int occluded(const dvec3& light, std::uint32_t replica = 0) {
    constexpr int kRays = 2000;
    std::uniform_real_distribution<double> side(-3.9999, 3.9999);
    int count = 0;
    for (int i = 0; i < kRays; ++i) {
      const dvec3 from = dvec3(shift_) + dvec3(side(random_), side(random_), 0);
      const double distance = length(light - from);
      RoundedArithmetic rounded(*rounded_, static_cast<std::uint64_t>(i) + replica * (std::uint64_t{1} << 32));
      Arithmetic exact;
      Arithmetic& arithmetic = replica > 0 ? rounded : exact;
      const Ray ray{from, arithmetic.lightDirection((light - from) / distance)};
      count += arithmetic.isOccluded(*tracing_, ray, {distance, kNoPrimitive, light}, counters_);
    }
    return count;
  }
  static constexpr int kAll = 2000;

 private:
  scene::Scene scene_;
  vec3 shift_;
  std::optional<Tracing> tracing_;
  std::optional<RoundedTracing> rounded_;
  Counters counters_;
  std::mt19937 random_{1};
};

const std::vector<vec3> kShifts{{0, 0, 0}, {100000, -100000, 100000}};

// Without the floor, from which replicas of these rays would have to be moved away.
scene::Scene sceneWith(const test::TouchedSurface& surface, const vec3& shift) {
  SceneBuilder b = test::floorUnder(shift);
  b.scene.primitives.clear();
  surface.add({b, shift});
  return b.scene;
}

}  // namespace

TEST_CASE("a light on a surface illuminates everything in front of it, exactly and in replicas") {
  for (const vec3& shift : kShifts) {
    for (const test::TouchedSurface& surface : test::touchedSurfaces()) {
      CAPTURE(surface.name, shift.x);
      const dvec3 light(surface.light + shift);
      CHECK(ShadowRays(sceneWith(surface, shift), shift).occluded(light) == 0);
      ShadowRays perturbed(sceneWith(surface, shift), shift, 1);
      for (std::uint32_t replica = 1; replica <= 3; ++replica) CHECK(perturbed.occluded(light, replica) == 0);
    }
  }
}

TEST_CASE("a light behind a surface by half the margin illuminates, and by more than the margin it does not") {
  for (const vec3& shift : kShifts) {
    for (const test::TouchedSurface& surface : test::touchedSurfaces()) {
      CAPTURE(surface.name, shift.x);
      const dvec3 light(surface.light + shift);
      const dvec3 inward = normalize(dvec3(surface.inward));
      const double least = kLightMargin * maxNorm(light);
      ShadowRays rays(sceneWith(surface, shift), shift);
      CHECK(rays.occluded(light + 0.5 * least * inward) == 0);
      // The depth in an oblique triangle or an edge is less than along `inward`, by a factor below 4.
      CHECK(rays.occluded(light + 4.0 * test::marginNear(shift) * inward) == ShadowRays::kAll);
    }
  }
}

TEST_CASE("rays that pass through a touched body to a light on its far side are occluded") {
  SceneBuilder b = test::floorUnder(vec3(0));
  b.scene.primitives.clear();
  b.sphere({0, 0, 3}, 1).cone({-4, 0, 6}, 1, {4, 0, 6}, 1).box({-1, -1, 9}, {1, 1, 10});
  const Tracing tracing(b.scene, render::defaultSettings());
  Counters counters;
  for (const double top : {4.0, 7.0, 10.0}) {
    const dvec3 light(0, 0, top);
    for (const double x : {-0.4, -0.01, 0.0, 0.02, 0.3}) {
      const dvec3 from(x, 0.5 * x, top - 2.5);
      const double distance = length(light - from);
      CAPTURE(top, x);
      CHECK(tracing.isOccluded({from, (light - from) / distance}, {distance, kNoPrimitive, light}, counters));
      // From inside, only the light's own surface is in the way.
      const dvec3 inside(x, 0.5 * x, top - 0.5);
      const double depth = length(light - inside);
      CHECK_FALSE(tracing.isOccluded({inside, (light - inside) / depth}, {depth, kNoPrimitive, light}, counters));
    }
  }
}

TEST_CASE("the depth of a light behind a wall does not depend on where the ray comes from") {
  SceneBuilder b;
  b.material(test::diffuseMaterial(vec3(1))).quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0});
  const Tracing tracing(b.scene, render::defaultSettings());
  Counters counters;
  for (const double distance : {1.0, 1e3, 1e6}) {
    for (const double slope : {1.0, 1e-2, 1e-4}) {
      const dvec3 towards = normalize(dvec3(1, 0, -slope));
      const auto isHidden = [&](double depth) {
        const dvec3 light(0.25, 0.5, -depth);
        // Shortened, as rounding may do.
        const Ray ray{light - distance * towards * 0.999999, towards};
        return tracing.isOccluded(ray, {distance, kNoPrimitive, light}, counters);
      };
      CAPTURE(distance, slope);
      CHECK_FALSE(isHidden(0.99 * kLightMargin));
      CHECK(isHidden(1.01 * kLightMargin));
    }
  }
}

TEST_CASE("a light without a point has no margin, and a wall hides the light behind it however near") {
  SceneBuilder b;
  b.material(test::diffuseMaterial(vec3(1))).plane({0, 0, 4}, {1, 0, 4}, {0, 1, 4});
  const Tracing tracing(b.scene, render::defaultSettings());
  Counters counters;
  const Ray ray{{0, 0, 0}, {0, 0, 1}};
  const double beyond = std::nextafter(4.0, 5.0);
  CHECK(tracing.isOccluded(ray, {beyond}, counters));
  CHECK_FALSE(tracing.isOccluded(ray, {beyond, kNoPrimitive, dvec3(0, 0, beyond)}, counters));
}

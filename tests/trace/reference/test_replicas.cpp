// Replicas of samples: whose errors count as amplified, so that they leave the margin of the paired test.
#include <catch2/catch.hpp>
#include <cmath>

#include "host/trace/reference/reference_renderer.h"
#include "host/trace/reference/rounding/rounded_tracing.h"
#include "tests/trace/reference/default_settings.h"
#include "tests/trace/reference/scene_builder.h"

using namespace candela;
using glm::vec3;
using test::SceneBuilder;

namespace {

struct Counted {
  std::uint64_t samples = 0;
  std::uint64_t amplified = 0;
};

Counted count(const scene::Scene& scene, render::Integrator integrator) {
  render::RenderSettings settings = render::defaultSettings();
  settings.image.size = {32, 32};
  settings.image.sampleCount = 4;
  settings.image.integrator = integrator;
  settings.image.maxDepth = 12;
  settings.execution.replicas = 1;
  const auto renderer = reference::makeReferenceRenderer();
  const auto session = renderer->prepare(scene, settings);
  session->advance({0, settings.image.sampleCount}, {});
  Counted counted;
  for (const render::Deviation& deviation : session->replicaSource()->replicas().deviations) {
    counted.samples += settings.image.sampleCount;
    counted.amplified += deviation.amplified;
  }
  return counted;
}

// A mirror ball in a white room of side 8, around `centre`. Whitted's tracer shows its light.
SceneBuilder roomAround(const vec3& centre) {
  SceneBuilder b;
  b.material(test::diffuseMaterial(vec3(0.7f)));
  const auto at = [&](float x, float y, float z) { return centre + 4.0f * vec3(x, y, z); };
  b.quad(at(-1, -1, -1), at(1, -1, -1), at(1, 1, -1), at(-1, 1, -1));
  b.quad(at(-1, -1, 1), at(-1, 1, 1), at(1, 1, 1), at(1, -1, 1));
  b.quad(at(-1, -1, -1), at(-1, 1, -1), at(-1, 1, 1), at(-1, -1, 1));
  b.quad(at(1, -1, -1), at(1, -1, 1), at(1, 1, 1), at(1, 1, -1));
  b.quad(at(-1, 1, -1), at(1, 1, -1), at(1, 1, 1), at(-1, 1, 1));
  b.material(test::mirrorMaterial(vec3(0.9f))).sphere(centre, 1);
  b.pointLight(centre + vec3(2, -3, 3), vec3(1));
  b.view(centre + vec3(0.5f, -3, 0.75f), centre, {0, 0, 1}, 60);
  return b;
}

}  // namespace

TEST_CASE("the rounding of large coordinates at one mirror ball does not count as amplified") {
  for (const float distance : {0.0f, 1e3f, 1e4f, 1e5f}) {
    CAPTURE(distance);
    const scene::Scene scene = roomAround(vec3(distance, distance, -distance)).scene;
    CHECK(count(scene, render::Integrator::whitted).amplified == 0);
  }
}

TEST_CASE("errors that mirror balls reflect back and forth are amplified, near the origin and far from it") {
  for (const float distance : {0.0f, 1e3f, 1e4f}) {
    CAPTURE(distance);
    const vec3 centre(distance, distance, -distance);
    SceneBuilder b = roomAround(centre);
    for (const float x : {-1.5f, 1.5f}) {
      for (const float z : {-1.5f, 1.5f}) b.sphere(centre + vec3(x, 0.5f, z), 0.9f);
    }
    const Counted counted = count(b.scene, render::Integrator::path);
    CAPTURE(counted.amplified, counted.samples);
    CHECK(counted.amplified > counted.samples / 200);
    CHECK(counted.amplified < counted.samples / 2);
  }
}

TEST_CASE("the lean of replicas is the signed sum of differences: rounding alone has little") {
  render::RenderSettings settings = render::defaultSettings();
  settings.image.size = {32, 32};
  settings.image.sampleCount = 16;
  settings.execution.replicas = 1;
  SceneBuilder b;
  b.material(test::diffuseMaterial(vec3(0.7f))).quad({-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0});
  b.pointLight({1, -2, 3}, vec3(1)).view({0, -4, 2}, {0, 0, 0}, {0, 0, 1}, 40);
  const auto session = reference::makeReferenceRenderer()->prepare(b.scene, settings);
  session->advance({0, settings.image.sampleCount}, {});
  double magnitude = 0;
  double lean = 0;
  for (const render::Deviation& deviation : session->replicaSource()->replicas().deviations) {
    magnitude += deviation.magnitude[3];
    lean += deviation.lean[3];
    CHECK(std::abs(deviation.lean[3]) <= deviation.magnitude[3]);
  }
  CHECK(magnitude > 0);
  CHECK(std::abs(lean) < 0.3 * magnitude);
}

TEST_CASE("a rug on an inclined floor of 1000 times its size makes no light a matter of rounding") {
  // The vertices of both are rounded by up to 6e-5. Without the tolerance of the floor, replicas would hit the floor
  // below the rug.
  const auto at = [](double x, double y) { return vec3(glm::dvec3(x, y, 0.723456789 * x - 0.6456789123 * y)); };
  render::RenderSettings settings = render::defaultSettings();
  settings.image.size = {16, 16};
  settings.image.sampleCount = 8;
  settings.execution.replicas = 1;
  for (int i = 0; i < 8; ++i) {
    SceneBuilder b;
    b.scene.background = vec3(1);
    b.material(test::diffuseMaterial(vec3(0.5f)));
    b.quad(at(-1000.3 - 9 * i, -907.1), at(1003.7, -1100.9), at(1104.1, 1000.3 + 7 * i), at(-1001.9, 1000.7));
    b.triangle(at(-2, -1.3), at(1.7, -1.1), at(0.3, 2.1));
    b.view(vec3(-0.7f, 0.65f, 1) * 3.0f, {0, 0, 0}, {0, 1, 0}, 25);
    const auto session = reference::makeReferenceRenderer()->prepare(b.scene, settings);
    session->advance({0, settings.image.sampleCount}, {});
    double magnitude = 0;
    for (const render::Deviation& deviation : session->replicaSource()->replicas().deviations)
      magnitude += deviation.magnitude[3];
    CAPTURE(i);
    CHECK(magnitude < 1e-5 * 16 * 16 * settings.image.sampleCount);
  }
}

// The device rounds the distances of needles up by the bound of their error, so that it may hit what is behind one.
TEST_CASE("replicas hit what is behind a needle by less than the bound of its distance, and nothing farther behind") {
  const auto hitsBehind = [](float gap) {
    // The ray meets the needle, which is almost parallel to it, at the distance of 10.
    SceneBuilder b;
    b.material(test::diffuseMaterial(vec3(0.5f)));
    b.triangle({-1, -0.999f, -10}, {-0.999f, -1, -10}, {1, 1, 10}).triangle({-9, -9, gap}, {9, -9, gap}, {0, 9, gap});
    render::RenderSettings settings = render::defaultSettings();
    settings.execution.replicas = 1;
    const reference::Tracing tracing(b.scene, settings);
    const reference::RoundedTracing rounded(b.scene, tracing, {0, 0, -10});
    std::uint32_t behind = 0;
    for (std::uint64_t word = 0; word < 64; ++word) {
      reference::Ray ray{{0, 0, -10}, {0, 0, 1}};
      reference::Counters counters;
      const reference::Hit hit = rounded.closest(ray, counters, {glm::dvec3(0), word});
      REQUIRE(hit.primitive != reference::kNoPrimitive);
      behind += hit.primitive;
    }
    return behind;
  };
  CHECK(hitsBehind(3e-4f) > 0);
  CHECK(hitsBehind(3e-4f) < 64);
  CHECK(hitsBehind(0.1f) == 0);
}

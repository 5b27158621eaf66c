// Three estimators of the same light: by light samples, by BSDF samples, and by both with weights.
#include <catch2/catch.hpp>

#include "tests/trace/proof/cells.h"
#include "tests/trace/proof/leaves.h"
#include "tests/trace/proof/numbers.h"
#include "tests/trace/reference/estimate.h"
#include "tests/trace/reference/scene_builder.h"

using namespace candela;
using namespace candela::proof;
using glm::vec3;
using test::diffuseMaterial;
using test::Estimate;
using test::mixtureMaterial;
using test::SceneBuilder;

namespace {

constexpr std::size_t kEstimatorSamples = 1000000;

const scene::Material kFloor = mixtureMaterial(0.3f, 0.6f, 15);

// Lights over the origin, none of which occludes another one there.
SceneBuilder lampsAlone() {
  SceneBuilder b;
  b.material(diffuseMaterial(vec3(0), vec3(3, 2, 1))).sphere({-1.5f, 0.3f, 1.5f}, 0.6f);
  b.material(diffuseMaterial(vec3(0), vec3(1, 2, 3))).triangle({0.5f, -1, 1}, {1, 1, 1.5f}, {0.3f, 0.2f, 2});
  return b;
}

// The view is along the glossy reflection between the lights, with so small an angle that every ray hits the origin.
scene::Scene lampsOverFloor() {
  SceneBuilder b = lampsAlone();
  b.material(kFloor).plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  b.view({0.5f, -2.5f, 2.5f}, {0, 0, 0}, {0, 0, 1}, 1e-3f);
  return b.scene;
}

Estimate rendered(bool nextEventEstimation) {
  render::RenderSettings settings = test::settingsOf(32, 32, kEstimatorSamples >> 10);
  settings.image.sampler = render::SamplerKind::independent;
  settings.image.maxDepth = 2;
  settings.image.nextEventEstimation = nextEventEstimation;
  settings.image.seed = nextEventEstimation ? 1 : 2;
  return test::estimateOf(renderScene(lampsOverFloor(), settings).film);
}

// The floor's frame at the origin is that of the world.
Estimate byLightSamples() {
  const LightLeaves lights(lampsAlone().scene);
  const MaterialLeaves materials({kFloor});
  const std::vector<vec3> numbers = randomNumbers(kEstimatorSamples, 501);
  const dvec3 wo = normalize(dvec3(0.5, -2.5, 2.5));
  double sum = 0, squares = 0;
  for (std::uint32_t entry = 0; entry < 2; ++entry) {
    // Each light is sampled alone, so that the probability of the choice is divided out.
    const std::vector<LitPoint> lit = lights.sample(entry, {}, numbers);
    std::vector<DirectionPair> pairs;
    for (const LitPoint& point : lit) pairs.push_back({0, wo, point.wi});
    const std::vector<ScatterValue> values = materials.evaluate(pairs);
    const double probability = lights.choose(std::vector<std::uint32_t>{entry == 0 ? 0u : ~0u})[0].probability;
    double own = 0, ownSquares = 0;
    for (std::size_t i = 0; i < lit.size(); ++i) {
      if (lit[i].pdf == 0) continue;
      const double light = image::luminance(values[i].f * lit[i].emission) * lit[i].wi.z * probability / lit[i].pdf;
      own += light;
      ownSquares += light * light;
    }
    const double mean = own / kEstimatorSamples;
    sum += mean;
    squares += (ownSquares / kEstimatorSamples - mean * mean) / kEstimatorSamples;
  }
  return {sum, std::sqrt(squares)};
}

void checkAgreement(const char* names, const Estimate& a, const Estimate& b) {
  INFO(names << ": " << a.mean << " +- " << a.error << ", " << b.mean << " +- " << b.error);
  const double error = std::hypot(a.error, b.error);
  CHECK(error < 0.004 * a.mean);  // otherwise the next check would be weak
  CHECK(std::abs(a.mean - b.mean) < 4 * error);
}

}  // namespace

TEST_CASE("light sampling, BSDF sampling and both combined give the same light", "[swiftshader-slow]") {
  const Estimate lights = byLightSamples(), lobes = rendered(false), both = rendered(true);
  checkAgreement("lights and lobes", lights, lobes);
  checkAgreement("lights and both", lights, both);
  checkAgreement("lobes and both", lobes, both);
  CHECK(both.error < lobes.error);
}

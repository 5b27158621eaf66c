// The verdict on the two tracers themselves, over many runs with fresh seeds: its false alarms and its power.
#include <catch2/catch.hpp>

#include "host/judge/verify/light_test.h"
#include "tests/judge/verify/changed_renderer.h"
#include "tests/trace/render/render_support.h"

namespace candela::verify {
namespace {

constexpr int kRuns = 200;
constexpr double
    kBias = 0.05;  // large enough that 600 runs are short; the number of samples is in proportion to 1 / bias^2

// A plane under a spherical light, partly in the shadow of a ball, with direct light only: the image is proportional to
// the albedo of the plane and the ball, which have the same material.
scene::Scene shadowedPlane(float albedo) {
  scene::Scene scene = device::sceneFromText(
      "v\nfrom 4 0 2.5\nat 0 0 0\nup 0 0 1\nangle 40\nhither 0\nresolution 16 16\n"
      "f .5 .5 .5 1 0 0 0 0 1 0 1 0 0 0\npl 0 0 0 1 0 0 0 1 0\ns .4 .5 .4 .4\n"
      "f 0 0 0 1 0 0 0 0 1 0 1 8 8 8\ns 0 0 2 .5\n");
  scene.materials[0].diffuse->colour = glm::vec3(albedo);
  return scene;
}

int alarmsOf(float deviceAlbedo, double alpha) {
  const scene::Scene scene = shadowedPlane(0.5f);
  const scene::Scene changed = shadowedPlane(deviceAlbedo);
  ChangedRenderer device(device::testRenderer(), changed);
  const auto reference = reference::makeReferenceRenderer();
  render::RenderSettings settings = device::squareSettings(16, 1);
  settings.image.maxDepth = 2;
  int alarms = 0;
  for (int run = 0; run < kRuns; ++run) {
    settings.image.seed = static_cast<std::uint32_t>(run);
    const LightTestOptions options{.alpha = alpha, .bias = kBias};
    alarms += testLight(scene, settings, device, *reference, options, {}).differs() ? 1 : 0;
  }
  return alarms;
}

TEST_CASE("device and reference raise no false alarm in 200 runs, and the expected number at alpha 0.05", "[slow]") {
  CHECK(alarmsOf(0.5f, 1e-4) == 0);
  const int alarms = alarmsOf(0.5f, 0.05);
  CHECK(alarms >= 2);
  CHECK(alarms <= 21);
}

TEST_CASE("an albedo that is higher on one side by the detectable bias is detected in 198 of 200 runs", "[slow]") {
  CHECK(alarmsOf(0.5f * static_cast<float>(1 + kBias), 1e-4) >= 198);
}

}  // namespace
}  // namespace candela::verify

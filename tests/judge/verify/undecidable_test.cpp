// Scenes whose samples single precision cannot decide. In the first, question 1 has nothing to test, and question 2
// finds what is wrong in paths that rounding has long separated. In the second, rounding excuses nearly all of the
// light from question 2, and question 3 finds a wrong reference.
#include <catch2/catch.hpp>

#include "host/formats/load_scene.h"
#include "host/judge/verify/verify.h"
#include "tests/judge/verify/changed_renderer.h"
#include "tests/trace/render/render_support.h"

namespace candela::verify {
namespace {

constexpr std::uint32_t kCellSide = 32;
constexpr double kCellBias = 0.01;

const VerifyReport& mirrorCell() {
  static const VerifyReport report = [] {
    const scene::Scene scene = formats::loadScene(std::filesystem::path(CANDELA_SOURCE_DIR) /
                                                  "tests/judge/verify/mirror_cell.p3f")
                                   .scene;
    const auto reference = reference::makeReferenceRenderer();
    return verifyScene(scene, device::squareSettings(kCellSide, 1), device::testRenderer(), *reference,
                       {.bias = kCellBias}, {});
  }();
  return report;
}

TEST_CASE("in a cell of mirrors, question 1 can decide no sample and raises no alarm", "[swiftshader-slow]") {
  const PixelAgreement& paths = mirrorCell().paths;
  CAPTURE(paths.decisions.text());
  CHECK(paths.decisions.undecidableFraction() > 0.99);
  CHECK(paths.decisions.odd == 0);
  CHECK(paths.agree());
}

TEST_CASE("in a cell of mirrors, question 2 finds the reference's light") {
  const LightTestResult& light = mirrorCell().light;
  CAPTURE(light.samplesPerPixel, differenceText(light.mostSignificant()));
  CHECK(light.information == 1);
  CHECK(light.image().detectableBias <= kCellBias);
  CHECK_FALSE(light.differs());
}

// Two balls of which the outer one is larger by half a rounding: which of them a ray hits, and whether the ray from
// there hits the other, is a matter of rounding. Exact arithmetic shows half of the sky.
scene::Scene nestedBalls(float albedo) {
  scene::Scene scene = device::sceneFromText(
      "b 1 1 1\nv\nfrom 0 0 1.2\nat 0 0 0\nup 0 1 0\nangle 20\nhither 0\nresolution 24 24\n"
      "f .5 .5 .5 1 0 0 0 0\ns 0 0 0 1\ns 0 0 0 0.9999999\n");
  scene.materials[0].diffuse->colour = glm::vec3(albedo);
  scene.exactMean = scene::ExactMean{.rgb = glm::vec3(0.5f)};
  return scene;
}

VerifyReport verifyNestedBalls(float albedoOfReference) {
  const scene::Scene scene = nestedBalls(0.5f);
  const scene::Scene changed = nestedBalls(albedoOfReference);
  const auto reference = reference::makeReferenceRenderer();
  ChangedRenderer changedReference(*reference, changed);
  return verifyScene(scene, device::squareSettings(24, 1), device::testRenderer(), changedReference, {}, {});
}

TEST_CASE("where two balls nearly coincide, question 2 decides nothing, and question 3 finds a wrong reference") {
  const VerifyReport right = verifyNestedBalls(0.5f);
  CHECK(right.doubt() == Doubt::rounding);
  CHECK(right.paths.agree());
  CHECK_FALSE(right.light.differs());
  CHECK(right.exact.value().isMet());
  CHECK(right.exact->referenceSamplesPerPixel > 0);

  const VerifyReport wrong = verifyNestedBalls(0.495f);
  CHECK_FALSE(wrong.light.differs());
  CHECK(wrong.exact.value().referenceDiffers());
  CHECK_FALSE(wrong.exact->deviceDiffers());
  CHECK(wrong.exact->reference == Approx(0.495).epsilon(0.001));
  CHECK(wrong.conclusion() == Conclusion::different);
}

}  // namespace
}  // namespace candela::verify

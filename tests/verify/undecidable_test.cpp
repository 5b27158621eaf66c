// A scene whose samples single precision cannot decide: question 1 has nothing to test, and question 2 finds what is
// wrong in paths that rounding has long separated.
#include <catch2/catch.hpp>

#include "host/formats/load_scene.h"
#include "host/verify/verify.h"
#include "tests/render/render_support.h"

namespace candela::verify {
namespace {

constexpr std::uint32_t kCellSide = 32;
constexpr double kCellBias = 0.01;

const VerifyReport& mirrorCell() {
  static const VerifyReport report = [] {
    const scene::Scene
        scene = formats::loadScene(std::filesystem::path(CANDELA_SOURCE_DIR) / "tests/verify/mirror_cell.p3f").scene;
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

}  // namespace
}  // namespace candela::verify

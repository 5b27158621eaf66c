// The tests of light where rounding decides a part of it: neither test excuses more than the limit, neither raises an
// alarm because of a lean, and neither contradicts the other.
#include <catch2/catch.hpp>

#include "host/judge/verify/paired_sums.h"
#include "host/judge/verify/paired_test.h"
#include "host/judge/verify/verify.h"
#include "tests/judge/verify/paired_renderer.h"
#include "tests/trace/reference/default_settings.h"

namespace candela::verify {
namespace {

using Catch::Contains;

// A device that is brighter by 12 % because it always decides one way at ties; its replicas do in half of the cases.
const PairedOptions kLeaning{.flips = 0.12, .jump = 1, .oneWay = true};

struct TwoTests {
  LightTestResult paired, independent;
};

TwoTests runBoth(const PairedOptions& options, const LightTestOptions& test = {}) {
  PairedRenderer device(PairedRole::device, options), reference(PairedRole::reference, options);
  render::RenderSettings settings = render::defaultSettings();
  settings.image.size = {64, 64};
  return {testLightPaired(scene::Scene{}, settings, device, reference, test, 1, {}),
          testLight(scene::Scene{}, settings, device, reference, test, {})};
}

TEST_CASE("a lean at ties is neither a difference nor an agreement, for both tests") {
  const TwoTests tests = runBoth(kLeaning);
  for (const LightTestResult* result : {&tests.paired, &tests.independent}) {
    const RegionResult& image = result->image();
    CAPTURE(differenceText(image), image.excused);
    CHECK_FALSE(result->differs());
    CHECK(image.relativeDifference() == Approx(0.12).epsilon(0.1));
    CHECK(doubtOf(image, kMaxOverlooked) == Doubt::rounding);
    CHECK(image.relative(image.excused) == Approx(0.12).epsilon(0.1));
    CHECK(isLostBySinglePrecision(image));
  }
}

TEST_CASE("the independent test keeps its level at a difference that rounding just excuses, by an estimate") {
  // A hundredth of the samples is a hundred times as bright on the device: the excuse has more noise than the means.
  const PairedOptions options{.flips = 0.01, .jump = 100, .oneWay = true};
  PairedRenderer device(PairedRole::device, options), reference(PairedRole::reference, options);
  render::RenderSettings settings = render::defaultSettings();
  settings.image.size = {16, 16};
  int alarms = 0;
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    settings.image.seed = seed;
    alarms += testLight(scene::Scene{}, settings, device, reference, {.alpha = 0.2, .bias = 1}, {}).differs() ? 1 : 0;
  }
  CHECK(alarms <= 36);  // P(more) < 0.001 if half of the level, that of this side, is reached
}

TEST_CASE("a difference beyond what rounding excuses is found by both tests") {
  PairedOptions options = kLeaning;
  options.factor = [](std::uint32_t, std::uint32_t) { return 0.7; };
  const TwoTests tests = runBoth(options);
  CHECK(tests.paired.differs());
  CHECK(tests.independent.differs());
}

TEST_CASE("both tests decide where rounding changes little") {
  const TwoTests tests = runBoth({.flips = 1e-4, .jump = 1});
  CHECK(doubtOf(tests.paired.image(), kMaxOverlooked) == Doubt::none);
  CHECK(doubtOf(tests.independent.image(), kMaxOverlooked) == Doubt::none);
}

TEST_CASE("a stated bias is the limit, if rounding excuses less") {
  const TwoTests tests = runBoth(kLeaning, {.bias = 0.3});
  CHECK(doubtOf(tests.paired.image(), 0.3) == Doubt::none);
  CHECK(doubtOf(tests.independent.image(), 0.3) == Doubt::none);
}

TEST_CASE("a comparison of both tracers is not decided for a lean, and says so in text and JSON") {
  PairedRenderer device(PairedRole::device, kLeaning), reference(PairedRole::reference, kLeaning);
  render::RenderSettings settings = render::defaultSettings();
  settings.image.size = {64, 64};
  settings.image.sampleCount = 16;
  const AgreementReport report = compareTracers(scene::Scene{}, settings, device, reference, {}, {});
  CHECK(report.conclusion() == Conclusion::undecided);
  CHECK_THAT(report.toText(),
             Contains("Not decided: rounding in single precision excuses") && Contains("12 % brighter"));
  CHECK(report.toJson()["agrees"].is_null());
  CHECK(report.toJson()["undecided"]["reason"] == "rounding");
  const AgreementReport lenient = compareTracers(scene::Scene{}, settings, device, reference, {.bias = 0.3}, {});
  CHECK(lenient.conclusion() == Conclusion::same);
}

// One pixel of one sample, of which the replica's errors are amplified.
struct DriftingPixel {
  double device, reference, drift;
};

RegionResult resultOf(const DriftingPixel& made, std::uint32_t side) {
  const std::vector<Region> regions{{0, 0, side, side, 0, Region::Quantity::luminance}};
  image::Film device(side, side), reference(side, side);
  std::vector<render::Deviation> deviations(std::size_t{side} * side);
  for (std::uint32_t i = 0; i < side * side; ++i) {
    device.addSample(i % side, i / side, glm::dvec3(made.device), 0);
    reference.addSample(i % side, i / side, glm::dvec3(made.reference), 0);
    deviations[i].drift = glm::dvec4(made.drift);
  }
  PairedSums sums(regions, 1);
  sums.add(device, reference, deviations);
  return sums.test(0, 1e-5);
}

TEST_CASE("a drift of replicas is an excuse that counts") {
  const RegionResult image = resultOf({0.75, 1, -0.25}, 64);
  CHECK_FALSE(image.differs);
  CHECK(image.margin < 1e-6);
  CHECK(image.excused == Approx(0.25).epsilon(1e-3));
  CHECK(image.replicaDifference == Approx(-0.25));
  CHECK(doubtOf(image, kMaxOverlooked) == Doubt::rounding);
  CHECK(isLostBySinglePrecision(image));
}

TEST_CASE("equal pixels that are too few for any alarm decide nothing") {
  CHECK(doubtOf(resultOf({1, 1, 0}, 2), 1) == Doubt::noise);
  CHECK(doubtOf(resultOf({1, 1, 0}, 16), kMaxOverlooked) == Doubt::none);
}

}  // namespace
}  // namespace candela::verify

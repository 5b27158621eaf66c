// A comparison may overlook something: its limit, its reason, its figures and its words are tested, for results made up
// by hand.
#include "host/judge/verify/conclusion.h"

#include <catch2/catch.hpp>
#include <limits>
#include <nlohmann/json.hpp>

namespace candela::verify {
namespace {

using Catch::Contains;

// A reference of mean 2 and a device that is darker by `lean`; all other figures are fractions of that mean, too.
struct MadeResult {
  double lean = 0;
  double standardError = 0.001;
  double excused = 0;
  double replicas = 0;
  double noise = 0;

  RegionResult result() const {
    RegionResult image;
    image.referenceMean = 2;
    image.deviceMean = 2 * (1 - lean);
    image.test.difference = -2 * lean;
    image.test.standardError = 2 * standardError;
    image.margin = image.excused = 2 * excused;
    image.replicaDifference = -2 * replicas;
    image.replicaStandardError = 2 * standardError;
    image.detectableBias = excused + noise;
    return image;
  }
};

std::string textOf(const MadeResult& made, double maxOverlooked = kMaxOverlooked) {
  const RegionResult image = made.result();
  return doubtText(doubtOf(image, maxOverlooked), image, maxOverlooked);
}

TEST_CASE(
    "the limit of what may be overlooked is absolute, and the reason is rounding where its excuse alone exceeds it") {
  CHECK(doubtOf(MadeResult{.excused = 0.004, .noise = 0.005}.result(), 0.01) == Doubt::none);
  CHECK(doubtOf(MadeResult{.excused = 0.006, .noise = 0.005}.result(), 0.01) == Doubt::noise);
  CHECK(doubtOf(MadeResult{.excused = 0.011, .noise = 0.005}.result(), 0.01) == Doubt::rounding);
  CHECK(doubtOf(MadeResult{.excused = 0.011, .noise = 0.005}.result(), 0.02) == Doubt::none);
  CHECK(doubtOf(MadeResult{.excused = 0.67, .noise = 0.02}.result(), 0.01) == Doubt::rounding);
  CHECK(doubtOf(RegionResult{}, 0.01) == Doubt::darkness);
}

TEST_CASE("a test that can find nothing hides everything") {
  const MadeResult blind{.noise = std::numeric_limits<double>::infinity()};
  CHECK(doubtOf(blind.result(), 1) == Doubt::noise);
  CHECK_THAT(textOf(blind), Contains("noise may hide a difference of any size"));
}

TEST_CASE("an undecided verdict states the limit, and the sign and size of what was excused") {
  const std::string text = textOf({.lean = 0.12, .standardError = 0.003, .excused = 0.67});
  CHECK_THAT(
      text, Contains("Not decided: rounding in single precision excuses a difference of 67 % of the image mean, and at "
                     "most 1 % may be excused."));
  CHECK_THAT(text, Contains("The device is 12 % darker than the reference (standard error 0.3 %)."));
  CHECK_THAT(textOf({.lean = -0.47, .excused = 4.7}), Contains("difference of 470 %") && Contains("47 % brighter"));
  CHECK(textOf({.lean = 0.005, .excused = 0.006}).empty());
}

TEST_CASE("light that replicas lose, too, is said to be lost by single precision") {
  CHECK_THAT(textOf({.lean = 0.12, .excused = 0.67, .replicas = 0.11}),
             Contains("replicas with perturbed arithmetic are 11 % darker than exact arithmetic, too, so that single "
                      "precision loses this light"));
  CHECK_THAT(textOf({.lean = -0.12, .excused = 0.67, .replicas = -0.3}), Contains("adds this light"));
  for (const MadeResult& other : {MadeResult{.lean = 0.12, .excused = 0.67, .replicas = 0.02},
                                  MadeResult{.lean = 0.12, .excused = 0.67, .replicas = -0.12},
                                  MadeResult{.lean = 0.12, .standardError = 0.05, .excused = 0.67, .replicas = 0.12},
                                  MadeResult{.lean = 0.0001, .excused = 0.67, .replicas = 0.12}}) {
    CAPTURE(other.lean, other.replicas);
    CHECK_FALSE(isLostBySinglePrecision(other.result()));
  }
}

TEST_CASE("the remedy of noise is samples, and that of rounding is geometry or a larger limit, if one is possible") {
  const auto remedyOf = [](const MadeResult& made) {
    const RegionResult image = made.result();
    return remedyText(doubtOf(image, 0.01), image, "More samples");
  };
  CHECK_THAT(remedyOf({.noise = 0.02}),
             Contains("More samples, or a larger bias, would decide it.") && !Contains("coincide"));
  CHECK_THAT(remedyOf({.excused = 0.02}), Contains("surfaces that coincide") && Contains("bias = 3% accepts"));
  CHECK_THAT(remedyOf({.excused = 0.8}), !Contains("bias"));
  CHECK(remedyOf({}).empty());
}

TEST_CASE("JSON has the reason and all figures as fractions of the mean, or null") {
  const RegionResult image = MadeResult{.lean = 0.12, .excused = 0.67, .replicas = 0.11, .noise = 0.02}.result();
  const nlohmann::ordered_json json = doubtJson(doubtOf(image, 0.01), image, 0.01);
  CHECK(json["reason"] == "rounding");
  CHECK(json["maxOverlookedFraction"] == 0.01);
  CHECK(json["overlookedFraction"].get<double>() == Approx(0.69));
  CHECK(json["excusedFraction"].get<double>() == Approx(0.67));
  CHECK(json["differenceFraction"].get<double>() == Approx(-0.12));
  CHECK(json["replicaDifferenceFraction"].get<double>() == Approx(-0.11));
  CHECK(json["lostBySinglePrecision"] == true);
  CHECK(doubtJson(Doubt::none, image, 0.01).is_null());
  CHECK(agreesJson(Conclusion::undecided).is_null());
}

}  // namespace
}  // namespace candela::verify

// Decidable samples: which participant is odd, how this is confirmed, and how often a correct device is odd.
#include "host/judge/verify/decisions.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/judge/verify/made_replicas.h"

namespace candela::verify {
namespace {

using Catch::Contains;

constexpr render::Extent kSize{64, 64};
constexpr double kLevel = 0.5e-4;

struct DecisionRun {
  DecisionTest test;
  std::uint64_t replicas;
};

// `device(pixel, x, y)` is the device's value.
template <class Device>
DecisionRun runDecisions(const std::vector<MadePixel>& pixels, unsigned seed, Device device) {
  MadeReplicas replicas(kSize, pixels, seed);
  image::Film film(kSize.width, kSize.height);
  for (std::uint32_t y = 0; y < kSize.height; ++y) {
    for (std::uint32_t x = 0; x < kSize.width; ++x) {
      film.addSample(x, y, glm::dvec3(device(pixels[y * kSize.width + x], x, y)), 0);
    }
  }
  return {testDecisions(film, replicas, kLevel), replicas.traced};
}

std::vector<MadePixel> allAlike(const MadePixel& pixel) {
  return std::vector<MadePixel>(std::size_t{kSize.width} * kSize.height, pixel);
}

double honest(const MadePixel& pixel, unsigned seed, std::uint32_t x, std::uint32_t y) {
  return MadeReplicas::made(pixel, {~seed, x, y, 99}).radiance.x;
}

TEST_CASE("a correct device is odd no more often than a replica, whatever rounding can decide") {
  for (const double share : {0.0, 1e-3, 0.02, 0.2, 0.5}) {
    for (unsigned seed = 0; seed < 5; ++seed) {
      const auto device = [seed](const MadePixel& p, std::uint32_t x, std::uint32_t y) {
        return honest(p, seed, x, y);
      };
      const DecisionTest test = runDecisions(allAlike({.left = 1, .right = 0.25, .share = share}), seed, device).test;
      CAPTURE(share, seed, test.odd, test.oddDevice, test.pValue);
      CHECK(test.agrees());
      CHECK(test.undecidableFraction() == Approx(1 - (1 - share) * (1 - share)).margin(0.03));
    }
  }
}

TEST_CASE("a device that always decides one way is not odd where replicas show that rounding can decide") {
  for (const double share : {0.1, 0.25, 0.5, 0.75, 0.9}) {
    const auto device = [](const MadePixel& pixel, std::uint32_t, std::uint32_t) { return pixel.right; };
    const DecisionTest test = runDecisions(allAlike({.left = 1, .right = 0.25, .share = share}), 1, device).test;
    CAPTURE(share, test.odd, test.oddDevice);
    CHECK(test.agrees());
  }
}

TEST_CASE("a device that is wrong in ten decidable pixels of 4,096 is found, and the worst of them named") {
  const auto device = [](const MadePixel& pixel, std::uint32_t x, std::uint32_t y) {
    return x == 7 && y < 10 ? pixel.left * (1.001 + 0.001 * y) : pixel.left;
  };
  const DecisionTest test = runDecisions(allAlike({}), 1, device).test;
  CHECK(test.oddDevice == 10);
  CHECK_FALSE(test.agrees());
  CHECK(test.worstX == 7);
  CHECK(test.worstY == 9);
  CHECK(test.worst == Approx(0.01).epsilon(1e-3));
  CHECK_THAT(test.text(), Contains("the device's value is the outlier in 10"));
  CHECK(test.json()["oddDevice"] == 10);
}

TEST_CASE("an error of ten times the rounding is tolerated, one of 100 times is not") {
  const auto off = [](double error) {
    return [error](const MadePixel& pixel, std::uint32_t, std::uint32_t) { return pixel.left * (1 + error); };
  };
  CHECK(runDecisions(allAlike({.noise = 1e-6}), 1, off(1e-5)).test.agrees());
  CHECK_FALSE(runDecisions(allAlike({.noise = 1e-6}), 1, off(1e-4)).test.agrees());
}

TEST_CASE("a device that is wrong everywhere is found by a bounded number of replicas") {
  const auto device = [](const MadePixel&, std::uint32_t, std::uint32_t) { return 5.0; };
  const DecisionRun result = runDecisions(allAlike({}), 1, device);
  CHECK(result.test.candidates == 4096);
  CHECK(result.test.oddDevice == kMaxCandidates);
  CHECK(result.replicas <= kReplicas * 4096 + kMaxCandidates * kConfirmations);
  CHECK_FALSE(result.test.agrees());
}

TEST_CASE("a scene without decidable samples agrees, and the report says so") {
  const auto device = [](const MadePixel&, std::uint32_t x, std::uint32_t) { return 1.0 + x; };
  std::vector<MadePixel> pixels = allAlike({.left = 1, .right = 2, .share = 0.5});
  const DecisionTest test = runDecisions(pixels, 3, device).test;
  CHECK(test.undecidableFraction() > 0.7);
  CHECK(test.agrees());
  CHECK_THAT(test.text(), Contains("cannot be decided in single precision (amplification up to 1.0e+02 at vertex 3)"));
}

TEST_CASE("without replicas there is no test") {
  MadeReplicas replicas(kSize, {}, 1);
  const DecisionTest test = testDecisions(image::Film(kSize.width, kSize.height), replicas, kLevel);
  CHECK_FALSE(test.isPossible);
  CHECK(test.agrees());
}

}  // namespace
}  // namespace candela::verify

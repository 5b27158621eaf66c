// False alarms of the test of two sets: 1,000 comparisons of renders of equal light for each kind of noise.
#include <catch2/catch.hpp>

#include "host/base/statistics/error_rates.h"
#include "tests/judge/verify/set_cases.h"

namespace candela::verify {
namespace {

constexpr std::uint32_t kCalibrationRuns = 1000;

// The number of alarms that a test of this level exceeds with a probability of at most 1 %.
int permittedAlarms(double level) {
  std::uint64_t count = 0;
  while (statistics::binomialTail(count + 1, kCalibrationRuns, level) > 0.01) ++count;
  return static_cast<int>(count);
}

// A test that takes pixels as independent: the error of the image mean from the variances of pixels among renders.
double pValueOfIndependentPixels(const SetPictures& pictures) {
  const std::size_t pixels = pictures.a.front().rgb.size();
  statistics::Estimate a, b;
  for (auto [estimate, renders] : {std::pair(&a, &pictures.a), std::pair(&b, &pictures.b)}) {
    estimate->degreesOfFreedom = static_cast<double>(pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
      std::vector<double> values;
      for (const image::Image& render : *renders) values.push_back(image::luminance(glm::dvec3(render.rgb[i])));
      const statistics::Summary summary = statistics::summarise(values);
      estimate->mean += summary.mean / static_cast<double>(pixels);
      estimate->squaredError += summary.squaredError() / static_cast<double>(pixels * pixels);
    }
  }
  return statistics::welch(a, b).pValue;
}

TEST_CASE("the permitted numbers of alarms are the 99 % quantiles of the binomial distribution") {
  CHECK(permittedAlarms(0.05) == 67);
  CHECK(permittedAlarms(0.01) == 18);
}

TEST_CASE("sets of equal light give no more alarms than the level, for any tails, correlated pixels and unequal noise",
          "[slow]") {
  for (const SetCase& one : setCases()) {
    if (!one.holdsLevel) continue;
    int alarmsOf5 = 0, alarmsOf1 = 0;
    for (std::uint32_t run = 0; run < kCalibrationRuns; ++run) {
      const double pValue = testPictures(one, picturesOf(one, run), 0.01).pValue;
      alarmsOf5 += pValue <= 0.05 ? 1 : 0;
      alarmsOf1 += pValue <= 0.01 ? 1 : 0;
    }
    INFO(one.name << ": " << alarmsOf5 << " and " << alarmsOf1);
    CHECK(alarmsOf5 <= permittedAlarms(0.05));
    CHECK(alarmsOf1 <= permittedAlarms(0.01));
    CHECK(alarmsOf5 >= one.leastAlarms);
  }
}

TEST_CASE("renders and a picture of equal light give no more alarms than the level", "[slow]") {
  for (const SetCase& one : pictureCases()) {
    int alarmsOf5 = 0, alarmsOf1 = 0;
    for (std::uint32_t run = 0; run < kCalibrationRuns; ++run) {
      const SetPictures pictures = picturesOf(one, run);
      alarmsOf5 += testPictures(one, pictures, 0.05).differs() ? 1 : 0;
      alarmsOf1 += testPictures(one, pictures, 0.01).differs() ? 1 : 0;
    }
    INFO(one.name << ": " << alarmsOf5 << " and " << alarmsOf1);
    CHECK(alarmsOf5 <= permittedAlarms(0.05));
    CHECK(alarmsOf1 <= permittedAlarms(0.01));
  }
}

TEST_CASE("a test that takes pixels as independent fails the same comparisons where samples are splatted") {
  int alarms = 0, alarmsOfBox = 0;
  const std::vector<SetCase> cases = setCases();
  constexpr std::uint32_t kFewRuns = 100;
  for (std::uint32_t run = 0; run < kFewRuns; ++run) {
    alarmsOfBox += pValueOfIndependentPixels(picturesOf(cases[0], run)) <= 0.05 ? 1 : 0;
    alarms += pValueOfIndependentPixels(picturesOf(cases[1], run)) <= 0.05 ? 1 : 0;
  }
  CHECK(statistics::binomialTail(static_cast<std::uint64_t>(alarmsOfBox), kFewRuns, 0.05) > 0.01);
  CHECK(statistics::binomialTail(static_cast<std::uint64_t>(alarms), kFewRuns, 0.05) < 1e-6);
}

}  // namespace
}  // namespace candela::verify

// Repeated, interleaved renders: their order, their medians, and images that differ.
#include "host/measure/bench/measure.h"

#include <catch2/catch.hpp>

#include "tests/measure/bench/fake_renderer.h"
#include "tests/trace/reference/default_settings.h"

namespace candela::bench {
namespace {

const std::vector<render::AccelKind> kKinds{render::AccelKind::none, render::AccelKind::grid, render::AccelKind::bvh};

std::vector<Variant> threeVariants() {
  std::vector<Variant> variants;
  for (const render::AccelKind kind : kKinds) {
    variants.push_back({"variant", render::defaultSettings()});
    variants.back().settings.structure.accel = kind;
  }
  return variants;
}

std::vector<Measurement> measure(std::vector<ScriptedRun> script, std::uint32_t repeats,
                                 Preparation preparation = Preparation::once) {
  FakeRenderer renderer(std::move(script));
  return measureInterleaved(renderer, scene::Scene{}, threeVariants(), repeats, {}, preparation);
}

const std::vector<ScriptedRun> kNineRuns{{1, 1.0}, {1, 2.0}, {1, 3.0}, {1, 9.0}, {1, 2.0},
                                         {1, 3.0}, {1, 2.0}, {1, 2.0}, {1, 3.0}};

TEST_CASE("every variant runs once before any runs twice") {
  FakeRenderer renderer(std::vector<ScriptedRun>(6));
  measureInterleaved(renderer, scene::Scene{}, threeVariants(), 2, {});
  std::vector<render::AccelKind> expected = kKinds;
  expected.insert(expected.end(), kKinds.begin(), kKinds.end());
  CHECK(renderer.accels == expected);
}

TEST_CASE("a measurement's rates are those of its median run") {
  const auto measurements = measure(kNineRuns, 3);
  REQUIRE(measurements.size() == 3);
  CHECK(measurements[0].traceSeconds == std::vector{1.0, 2.0, 9.0});
  CHECK(measurements[0].mraysPerSecond() == Approx(1500 / 2.0 / 1e6));
  CHECK(measurements[0].msamplesPerSecond() == Approx(1000 / 2.0 / 1e6));
  CHECK(measurements[0].stepsPerRay() == Approx(4));
}

TEST_CASE("the build time is measured once for each preparation") {
  CHECK(measure(kNineRuns, 3).front().buildSeconds == std::vector{0.25});
  CHECK(measure(kNineRuns, 3, Preparation::everyRun).front().buildSeconds == std::vector{0.25, 0.5, 2.25});
}

TEST_CASE("a variant whose image differs from most does not agree") {
  const auto measurements = measure({{1}, {2}, {1}}, 1);
  CHECK(measurements[0].agrees);
  CHECK_FALSE(measurements[1].agrees);
  CHECK(measurements[2].agrees);
}

TEST_CASE("a variant whose image changes from run to run does not agree") {
  const auto measurements = measure({{1}, {1}, {2}, {1}, {1}, {1}}, 2);
  CHECK(measurements[0].agrees);
  CHECK(measurements[1].agrees);
  CHECK_FALSE(measurements[2].agrees);
}

TEST_CASE("no image is regarded as correct if none has a majority") {
  for (const Measurement& measurement : measure({{1}, {2}, {3}}, 1)) CHECK_FALSE(measurement.agrees);
}

TEST_CASE("films are only compared among variants of the same image") {
  std::vector<Variant> variants = threeVariants();
  variants[2].image = "another";
  FakeRenderer renderer({{1}, {1}, {2}});
  for (const Measurement& measurement : measureInterleaved(renderer, scene::Scene{}, variants, 1, {}))
    CHECK(measurement.agrees);
}

TEST_CASE("noise is half of the relMSE between two other seeds, measured once for each image") {
  std::vector<Variant> variants = threeVariants();
  variants[2].image = "another";
  FakeRenderer renderer({{1}, {1}, {2}, {1}, {3}, {2}, {2}});
  std::vector<Measurement> measurements = measureInterleaved(renderer, scene::Scene{}, variants, 1, {});
  REQUIRE(measureNoise(renderer, scene::Scene{}, measurements, {}));
  CHECK(measurements[0].relMse == Approx((1.0 - 3) * (1.0 - 3) / (9 + 0.01) / 2));
  CHECK(measurements[1].relMse == measurements[0].relMse);
  CHECK(measurements[2].relMse == 0);
  CHECK(measurements[0].efficiency() == Approx(1 / *measurements[0].relMse));
  CHECK(renderer.seeds == std::vector<std::uint32_t>{0, 0, 0, 1, 2, 1, 2});
}

TEST_CASE("noise is not measured if the benchmark is interrupted") {
  FakeRenderer renderer({{1}, {1}, {1}, {.interrupted = true}});
  std::vector<Measurement> measurements = measureInterleaved(renderer, scene::Scene{}, threeVariants(), 1, {});
  CHECK_FALSE(measureNoise(renderer, scene::Scene{}, measurements, {}));
}

TEST_CASE("the error is that of pictures with other seeds, against a reference of more samples, once for each image") {
  std::vector<Variant> variants = threeVariants();
  variants[2].image = "another";
  // Six runs, then a reference of 2 and pictures of 3 and 1, then a reference without noise.
  FakeRenderer renderer({{1, 4}, {1, 1}, {1, 2}, {1, 4}, {1, 1}, {1, 2}, {2}, {2}, {3}, {1}, {1}, {1}, {1}, {1}});
  std::vector<Measurement> measurements = measureInterleaved(renderer, scene::Scene{}, variants, 2, {});
  REQUIRE(measureError(renderer, scene::Scene{}, measurements, 2, {}));
  CHECK(renderer.seeds == std::vector<std::uint32_t>{0, 0, 0, 0, 0, 0, 1, 2, 3, 4, 1, 2, 3, 4});
  CHECK(std::vector(renderer.sampleCounts.begin() + 5, renderer.sampleCounts.begin() + 10) ==
        std::vector<std::uint32_t>{16, 128, 128, 16, 16});
  CHECK(measurements[0].relMse == Approx(1 / 4.01));
  CHECK(measurements[0].error->errorAfterSecond().value == Approx(std::sqrt(4 / 4.01)));
  CHECK(measurements[1].error->errorAfterSecond().value == Approx(std::sqrt(1 / 4.01)));
  CHECK(measurements[2].relMse == 0);
  CHECK_FALSE(measurements[2].error);
}

TEST_CASE("errors are not measured if the benchmark is interrupted") {
  for (const std::size_t runs : {0u, 1u, 3u}) {
    std::vector<ScriptedRun> script(6 + runs);
    script.push_back({.interrupted = true});
    FakeRenderer renderer(script);
    std::vector<Measurement> measurements = measureInterleaved(renderer, scene::Scene{}, threeVariants(), 2, {});
    CHECK_FALSE(measureError(renderer, scene::Scene{}, measurements, 2, {}));
  }
}

TEST_CASE("a variant whose work was truncated does not agree, whatever its image") {
  const auto measurements = measure({{1}, {.truncated = 1}, {1}}, 1);
  CHECK(measurements[0].agrees);
  CHECK_FALSE(measurements[1].agrees);
}

TEST_CASE("an interrupted benchmark has no measurements") {
  CHECK(measure({{1}, {.interrupted = true}, {1}}, 1).empty());
}

TEST_CASE("progress covers all runs") {
  std::vector<double> fractions;
  std::vector<std::uint64_t> samples;
  render::RenderControl control;
  control.progress = [&](double fraction, std::uint64_t done) {
    fractions.push_back(fraction);
    samples.push_back(done);
  };
  FakeRenderer renderer(std::vector<ScriptedRun>(3));
  measureInterleaved(renderer, scene::Scene{}, threeVariants(), 1, control);
  REQUIRE(fractions.size() == 3);
  CHECK(fractions[0] == Approx(1.0 / 3));
  CHECK(fractions[2] == Approx(1));
  CHECK(samples == std::vector<std::uint64_t>{1000, 2000, 3000});
}

}  // namespace
}  // namespace candela::bench

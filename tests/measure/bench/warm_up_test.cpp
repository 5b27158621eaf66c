// When a GPU counts as warm, and the runs that are timed once it is.
#include "host/measure/bench/warm_up.h"

#include <atomic>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "host/measure/bench/sweep_report.h"
#include "tests/measure/bench/fake_renderer.h"
#include "tests/trace/reference/default_settings.h"

namespace candela::bench {
namespace {

using Catch::Contains;

// Adds passes of one unit of work until the device is warm, the last duration repeatedly, and returns their number.
std::uint32_t passesUntilWarm(const std::vector<double>& seconds) {
  WarmUp warmUp;
  while (!warmUp.isDone()) warmUp.add(seconds.at(std::min<std::size_t>(warmUp.work().passes, seconds.size() - 1)), 1);
  return warmUp.work().passes;
}

std::vector<Measurement> measureOnGpu(const std::vector<double>& seconds, std::uint32_t repeats,
                                      const render::RenderControl& control = {}) {
  std::vector<ScriptedRun> script;
  for (const double duration : seconds) script.push_back({.traceSeconds = duration});
  FakeRenderer renderer(script);
  renderer.onGpu = true;
  const std::vector<Variant> variants{{"variant", render::defaultSettings()}};
  return measureInterleaved(renderer, scene::Scene{}, variants, repeats, control);
}

TEST_CASE("a device is warm when the rate of its work no longer rises") {
  CHECK(passesUntilWarm({0.05}) == 2);
  CHECK(passesUntilWarm({0.1, 0.1}) == 2);
  CHECK(passesUntilWarm({0.4, 0.2, 0.1, 0.05}) == 5);
  CHECK(passesUntilWarm({0.1, 0.0985}) == 2);  // 1.5 % faster
  CHECK(passesUntilWarm({0.1, 0.0975}) == 3);  // 2.6 % faster
  CHECK(passesUntilWarm({0.1, 0.2}) == 2);
}

TEST_CASE("the rate of short passes is that of windows, so that one of them decides nothing") {
  CHECK(passesUntilWarm({0.0099}) == 12);
  CHECK(passesUntilWarm({0.02, 0.01, 0.02, 0.01}) == 3 + 5 + 5);
}

TEST_CASE("a warm-up ends after a second, whatever the rate") {
  CHECK(passesUntilWarm({1.5}) == 1);
  CHECK(passesUntilWarm({0.6, 0.5, 0.4}) == 2);
}

TEST_CASE("on a GPU, every timed run follows a warm-up, which no figure includes") {
  const auto measurements = measureOnGpu({0.16, 0.08, 0.08, /* timed */ 0.07, 0.09, 0.08, 0.08, /* timed */ 0.06}, 2);
  REQUIRE(measurements.size() == 1);
  CHECK(measurements[0].traceSeconds == std::vector{0.06, 0.07});
  CHECK(measurements[0].statistics.samples == 1000);
  CHECK(measurements[0].statistics.seconds.at("trace") == 0.06);
  CHECK(measurements[0].warmUp.passes == 6);
  CHECK(measurements[0].warmUp.seconds == Approx(0.57));
}

TEST_CASE("a report states the mean duration of warm-ups, and the total of each row") {
  SweepReport report;
  report.repeats = 2;
  for (Measurement& m : measureOnGpu({0.16, 0.08, 0.08, 0.07, 0.09, 0.08, 0.08, 0.06}, 2))
    report.rows.push_back({"room", 1, std::move(m)});
  CHECK_THAT(toText(report), Contains("median of 2, runs interleaved, each after a warm-up of 0.29 s\n"));
  const nlohmann::json row = toJson(report)["rows"][0];
  CHECK(row["warmUpPasses"] == 6);
  CHECK(row["warmUpSeconds"] == Approx(0.57));
  CHECK(row["medianSeconds"] == Approx(0.065));
}

TEST_CASE("devices in software and the reference are not warmed up, and reports do not mention it") {
  FakeRenderer renderer(std::vector<ScriptedRun>{{.traceSeconds = 0.07}});
  const std::vector<Variant> variants{{"variant", render::defaultSettings()}};
  SweepReport report;
  for (Measurement& m : measureInterleaved(renderer, scene::Scene{}, variants, 1, {}))
    report.rows.push_back({"room", 1, std::move(m)});
  CHECK(toJson(report)["rows"][0]["warmUpPasses"] == 0);
  CHECK_THAT(toText(report), Contains("runs interleaved\n"));
}

TEST_CASE("progress is that of timed runs alone, and an interruption ends a warm-up") {
  std::vector<std::uint64_t> samples;
  render::RenderControl control;
  control.progress = [&](double, std::uint64_t done) { samples.push_back(done); };
  CHECK(measureOnGpu({0.08, 0.08, 0.07}, 1, control).size() == 1);
  CHECK(samples == std::vector<std::uint64_t>{1000});
  const std::atomic<bool> stop = true;
  control.stop = &stop;
  CHECK(measureOnGpu({0.08}, 1, control).empty());
}

}  // namespace
}  // namespace candela::bench

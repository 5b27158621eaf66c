// Reports of whole renders: rows, differing films, the line for publication, the chart.
#include "host/measure/bench/sweep_report.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/trace/reference/default_settings.h"

namespace candela::bench {
namespace {

using Catch::Contains;

Measurement measurementOf(const std::string& name, double seconds) {
  Measurement m{.variant = {name, render::defaultSettings()}};
  m.variant.settings.image.size = {10, 10};
  m.statistics.samples = 1'000'000;
  m.statistics.cameraRays = 1'000'000;
  m.statistics.bounceRays = 2'000'000;
  m.statistics.shadowRays = 1'000'000;
  m.statistics.device = "Some device";
  m.statistics.driver = "some driver 1.2";
  m.statistics.dispatchSeconds = {0.3, 0.1, 0.2};
  m.traceSeconds = {0.5 * seconds, seconds, 2 * seconds};
  m.pipelineSeconds = 0.25;
  m.relMse = 0.5;
  return m;
}

SweepReport report() {
  SweepReport report;
  report.repeats = 3;
  report.rows = {{"a.p3f", 1, measurementOf("workgroup=8x8", 2)},
                 {"a.p3f", 1, measurementOf("workgroup=<16>", 1)},
                 {"b.p3f", 2, measurementOf("workgroup=8x8", 4)}};
  report.rows[2].measurement.agrees = false;
  return report;
}

TEST_CASE("the rows of a sweep have rates by kind of ray, dispatch times, noise and the driver's compilation time") {
  const nlohmann::json document = toJson(report());
  CHECK(document["schema"] == "candela-bench/2");
  const nlohmann::json& row = document["rows"][0];
  CHECK(row["variant"] == "workgroup=8x8");
  CHECK(row["medianSeconds"] == 2);
  CHECK(row["spread"] == 1.5);
  CHECK(row["msamplesPerSecond"] == 0.5);
  CHECK(row["mraysPerSecond"] == 2);
  CHECK(row["mraysPerSecondByKind"] == nlohmann::json{{"camera", 0.5}, {"bounce", 1.0}, {"shadow", 0.5}});
  CHECK(row["dispatches"]["count"] == 3);
  CHECK(row["dispatches"]["medianSeconds"] == Approx(0.2));
  CHECK(row["dispatches"]["maxSeconds"] == Approx(0.3));
  CHECK(row["pipelineSeconds"] == Approx(0.25));
  CHECK(row["relMse"] == 0.5);
  CHECK(row["efficiency"] == 1);  // 1 / (2 s x 0.5)
}

TEST_CASE("the error in equal time has a column and an interval where it was measured") {
  CHECK_THAT(toText(report()), !Contains("error after 1 s"));
  SweepReport measured = report();
  const std::vector<double> errors{0.5, 0.5}, seconds{2, 2};
  measured.rows[0].measurement.error = errorInTime(errors, seconds);
  CHECK_THAT(toText(measured), Contains("error after 1 s") && Contains("100 % (100 to 100)"));
  const nlohmann::json document = toJson(measured);
  for (const char* const key : {"relMseLow", "relMseHigh", "errorAfterSecond", "errorAfterSecondHigh"}) {
    CHECK(document["rows"][0].contains(key));
    CHECK_FALSE(document["rows"][1].contains(key));
  }
}

TEST_CASE("a variant whose film differs has no figures, and the report does not agree") {
  const SweepReport bad = report();
  CHECK_FALSE(bad.agree());
  const nlohmann::json row = toJson(bad)["rows"][2];
  CHECK(row["agrees"] == false);
  CHECK_FALSE(row.contains("mraysPerSecond"));
  CHECK_THAT(toText(bad), Contains("differs"));
}

TEST_CASE("each scene with a score has a line with its fastest variant") {
  const std::string text = toText(report());
  const std::string lines = text.substr(text.rfind("\n\n") + 2);
  CHECK_THAT(lines, Contains("some driver 1.2 | a.p3f 10x10 x 16 spp | workgroup=<16> | 1.000 Msamples/s, 4.00 Mrays/s "
                             "| median of 3, spread 150 %"));
  CHECK_THAT(lines, !Contains("b.p3f"));
}

TEST_CASE("the chart has a bar for each variant with the length of its rate, and its labels are text") {
  const std::string svg = toSvg(report());
  CHECK_THAT(svg, Contains("workgroup=&lt;16&gt;") && !Contains("<16>"));
  CHECK_THAT(svg, Contains("width=\"200.0\"") && Contains("width=\"100.0\"") &&
                      Contains("width=\"0.0\""));  // 400 are 2 Msamples/s
  CHECK_THAT(svg, Contains("(differs)"));
}

}  // namespace
}  // namespace candela::bench

// The text and the JSON that report a search.
#include "host/measure/tune/tune_report.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/measure/tune/made_rows.h"

namespace candela::tune {
namespace {

using Catch::Contains;

const Candidate kOther = candidateWith({{"layout", "bvh2"}});

TuneReport reportOf(MadeTime other) {
  TuneReport report;
  report.result.rounds.push_back({"layout, loads", {madeRow(builtIn(), {{0.2}}), madeRow(kOther, {other})}});
  report.result.chosen = builtIn();
  return report;
}

TuneReport reportOfChoice() {
  TuneReport report = reportOf({0.1});
  report.result.chosen = kOther;
  report.result.chosenGain = 1.91;
  report.result.chosenNoise = 0.03;
  report.file = "/cache/a.json";
  return report;
}

TEST_CASE("the text has a row for each candidate, the choice, its gain over the built-in choice, and the file") {
  const std::string text = toText(reportOfChoice());
  CHECK_THAT(text, Contains("made, 4x4 x 16 spp, ms") && Contains("200.0") && Contains("100.0") && Contains("2.000"));
  CHECK_THAT(
      text,
      Contains("chosen: layout=bvh2 loads=auto workgroup=8x8 kernel=megakernel, 1.91 times as fast as the built-in "
               "layout=cwbvh loads=auto workgroup=8x8 kernel=megakernel (noise 3.0 %)"));
  CHECK_THAT(text, Contains("stored in /cache/a.json; untuned ignores it"));
  CHECK_THAT(toMarkdown(reportOfChoice()), Contains("| layout=bvh2 loads=auto workgroup=8x8 kernel=megakernel |"));
}

TEST_CASE("the text says that scenes are too small to tune the layout") {
  TuneReport report = reportOf({0.2});
  CHECK_THAT(toText(report), !Contains("not tuned"));
  report.result.tunesLayout = false;
  CHECK_THAT(toText(report), Contains("layout: not tuned, since the scenes have too few primitives for a BVH"));
}

TEST_CASE("the text says if nothing is faster or nothing is stored") {
  const std::string text = toText(reportOf({0.2}));
  CHECK_THAT(text, Contains("the built-in choice; no other is clearly faster") && Contains("nothing is stored"));
}

TEST_CASE("a candidate whose image differs shows the word differs instead of figures, and the report disagrees") {
  const TuneReport report = reportOf({0.1, 0, false});
  CHECK_FALSE(report.agree());
  CHECK_THAT(toText(report), Contains("differs") && !Contains("2.000"));
  const auto row = toJson(report)["rows"][1];
  CHECK(row["agrees"] == false);
  CHECK_FALSE(row.contains("speedup"));
}

TEST_CASE("nothing is chosen if the image of the built-in choice is wrong") {
  TuneReport report = reportOf({0.1});
  report.result.builtInAgrees = false;
  CHECK_THAT(toText(report), Contains("nothing is chosen"));
  CHECK(toJson(report)["chosen"].is_null());
}

TEST_CASE("the JSON report has every row, the choice and the file") {
  const auto json = toJson(reportOfChoice());
  CHECK(json["schema"] == "candela-tune-report/2");
  REQUIRE(json["rows"].size() == 2);
  CHECK(json["rows"][1]["speedup"] == Approx(2));
  CHECK(json["rows"][1]["choice"]["layout"] == "bvh2");
  CHECK(json["rows"][1]["scenes"][0]["medianSeconds"] == Approx(0.1));
  CHECK(json["builtIn"]["layout"] == "cwbvh");
  CHECK(json["chosen"]["layout"] == "bvh2");
  CHECK(json["speedup"] == 1.91);
  CHECK(json["file"] == "/cache/a.json");
}

}  // namespace
}  // namespace candela::tune

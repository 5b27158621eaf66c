// The formats of results.
#include "host/drivers/conformance/results.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace candela::conformance {
namespace {

using Catch::Contains;

RunResult madeRun() {
  return {{{"a.pass", {Status::pass}, "", 0.25},
           {"b.fail", {Status::fail}, "x < y & \"z\"\nsecond line", 1.5},
           {"c.skip", {Status::skip}, "no <feature>", 0},
           {"d.better", {Status::improvement, Status::pass}, "", 0.125}},
          false};
}

vulkan::DeviceInfo madeDevice() {
  vulkan::DeviceInfo device;
  device.name = "made & device";
  device.driver = "driver 1";
  return device;
}

}  // namespace

TEST_CASE("the CSV file has the columns of deqp-runner, and is a baseline") {
  const std::string csv = toCsv(madeRun());
  CHECK(csv ==
        "a.pass,Pass,0.250000\nb.fail,Fail,1.500000\nc.skip,Skip,0.000000\n"
        "d.better,UnexpectedImprovement(Pass),0.125000\n");
  const Baseline baseline = parseBaseline(csv, "results.csv");
  CHECK(baseline.size() == 4);
  CHECK(baseline.at("b.fail") == Status::fail);
}

TEST_CASE("JSON has every case, the counts and the device") {
  const nlohmann::ordered_json json = toJson(madeRun(), madeDevice(), 3);
  CHECK(json["schema"] == "candela-conformance/2");
  CHECK(json["device"] == "made & device");
  CHECK(json["agrees"] == false);
  CHECK(json["compileOnly"] == false);
  CHECK(json["counts"]["Pass"] == 1);
  CHECK(json["counts"]["UnexpectedImprovement"] == 1);
  CHECK(json["cases"].size() == 4);
  CHECK(json["cases"][1]["result"] == "Fail");
  CHECK(json["cases"][1]["agrees"] == false);
  CHECK(json["cases"][1]["text"] == "x < y & \"z\"\nsecond line");
}

TEST_CASE("JUnit XML has a failure for each unexpected result, escaped") {
  const std::string xml = toJunit(madeRun(), madeDevice(), 3);
  CHECK_THAT(xml, Contains("tests=\"4\" failures=\"2\" skipped=\"1\""));
  CHECK_THAT(xml, Contains("<failure type=\"Fail\" message=\"x &lt; y &amp; &quot;z&quot;\nsecond line\">"
                           "x &lt; y &amp; &quot;z&quot;\nsecond line</failure>"));
  CHECK_THAT(xml, Contains("<skipped message=\"no &lt;feature&gt;\"/>"));
  CHECK_THAT(xml, Contains("<failure type=\"UnexpectedImprovement(Pass)\""));
  CHECK_THAT(xml, Contains("name=\"candela conformance made &amp; device\""));
}

TEST_CASE("results say that cases were only compiled") {
  RunResult run = madeRun();
  run.compilesOnly = true;
  CHECK(toJson(run, madeDevice(), 3)["compileOnly"] == true);
  CHECK_THAT(toJunit(run, madeDevice(), 3), Contains("name=\"candela conformance --compile-only made &amp; device\""));
}

TEST_CASE("JUnit XML is well-formed whatever a text contains") {
  RunResult run = madeRun();
  run.cases[1].text = "bad \xff\xfe \xef\xbf\xbf \x1b driver";
  CHECK_THAT(toJunit(run, madeDevice(), 3), Contains("message=\"bad \xef\xbf\xbd\xef\xbf\xbd     driver\""));
}

TEST_CASE("the text names the result, the case and what differs") {
  CHECK(lineOf(madeRun().cases[1]) == "Fail b.fail (1.50 s)\n    x < y & \"z\"\n    second line\n");
  CHECK(interruptionOf(madeRun(), 42) == "interrupted after 4 of 42 cases");
  CHECK(interruptionOf({{}, true}, 1) == "interrupted after 0 of 1 case");
  CHECK(countsOf({{}, true}) == "no results");
  CHECK(countsOf(madeRun()) == "Pass: 1, Fail: 1, Skip: 1, UnexpectedImprovement: 1");
}

}  // namespace candela::conformance

// Exit codes, text and JSON of a diagnosis.
#include "host/drivers/doctor/diagnosis.h"

#include <catch2/catch.hpp>

namespace candela::doctor {
namespace {

using Catch::Contains;

Diagnosis diagnosisOf(TrialOutcome outcome) {
  Diagnosis diagnosis;
  diagnosis.devices.resize(1);
  diagnosis.devices[0].name = "made device";
  diagnosis.devices[0].type = "CPU";
  diagnosis.device = diagnosis.devices[0];
  diagnosis.checks = {{"part", Status::ok, "in order", ""}, {"other part", Status::warning, "slow", "wait"}};
  diagnosis.trial = Trial{outcome, {"test picture", Status::ok, "", ""}, {{"agrees", true}}};
  return diagnosis;
}

}  // namespace

TEST_CASE("the exit code says whether a render works, and whether its picture is right") {
  CHECK(diagnosisOf(TrialOutcome::works).code() == ExitCode::done);
  CHECK(diagnosisOf(TrialOutcome::wrong).code() == ExitCode::differ);
  CHECK(diagnosisOf(TrialOutcome::undecided).code() == ExitCode::undecided);
  CHECK(toJson(diagnosisOf(TrialOutcome::undecided))["agrees"].is_null());
  CHECK_THAT(toText(diagnosisOf(TrialOutcome::undecided)), Contains("is not decided"));
  CHECK(diagnosisOf(TrialOutcome::fails).code() == ExitCode::noDevice);
  CHECK(Diagnosis{}.code() == ExitCode::noDevice);
}

TEST_CASE("the text has one line for each check, one for each remedy, and the verdict") {
  CHECK(toText(diagnosisOf(TrialOutcome::works)) ==
        "ok       part: in order\n"
        "warning  other part: slow\n"
        "         how to fix: wait\n"
        "\n"
        "A render will work, on made device, in software: the picture is right, but a GPU is faster.\n");
  CHECK_THAT(toText(diagnosisOf(TrialOutcome::wrong)), Contains("WRONG"));
  CHECK_THAT(toText(Diagnosis{}), Contains("A render will not work"));
}

TEST_CASE("control characters do not reach the terminal") {
  Diagnosis diagnosis;
  diagnosis.checks = {{"a\nname", Status::problem, "\x1b[2J", "\x7f"}};
  CHECK_THAT(toText(diagnosis), Contains("a?name: ?[2J\n") && Contains("how to fix: ?\n"));
}

TEST_CASE("the JSON has the documented members") {
  const nlohmann::ordered_json json = toJson(diagnosisOf(TrialOutcome::works));
  CHECK(json["schema"] == "candela-doctor/2");
  CHECK(json["agrees"] == true);
  CHECK(json["exitCode"] == 0);
  CHECK(json["verdict"].is_string());
  CHECK(json["device"] == "made device");
  CHECK(json["checks"][1] ==
        nlohmann::ordered_json{{"name", "other part"}, {"status", "warning"}, {"text", "slow"}, {"remedy", "wait"}});
  CHECK(json["devices"][0]["name"] == "made device");
  CHECK(json["comparison"]["agrees"] == true);
  const nlohmann::ordered_json none = toJson(Diagnosis{});
  CHECK(none["agrees"].is_null());
  CHECK(none["exitCode"] == 4);
  CHECK(none["device"].is_null());
  CHECK(none["comparison"].is_null());
}

}  // namespace candela::doctor

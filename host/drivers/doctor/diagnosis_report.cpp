// The report of a diagnosis as text and as JSON.
#include <fmt/format.h>

#include <algorithm>

#include "host/base/report_head.h"
#include "host/drivers/doctor/devices.h"
#include "host/drivers/doctor/diagnosis.h"

namespace candela::doctor {
namespace {

// File names and messages of drivers may contain anything; control characters do not reach the terminal.
std::string printable(std::string text) {
  std::ranges::replace_if(
      text, [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
  return text;
}

std::string toText(const Check& check) {
  std::string text = fmt::format("{:<8} {}: {}\n", nameOf(check.status), printable(check.name), printable(check.text));
  if (!check.remedy.empty()) text += fmt::format("         how to fix: {}\n", printable(check.remedy));
  return text;
}

nlohmann::ordered_json toJson(const Check& check) {
  return {{"name", check.name}, {"status", nameOf(check.status)}, {"text", check.text}, {"remedy", check.remedy}};
}

// Returns whether the picture of a render is right; null if there is none, or if it is not decided.
nlohmann::ordered_json agreement(ExitCode code) {
  if (code == ExitCode::noDevice || code == ExitCode::undecided) return nullptr;
  return code == ExitCode::done;
}

}  // namespace

std::string toText(const Diagnosis& diagnosis) {
  std::string text;
  for (const Check& check : diagnosis.checks) text += toText(check);
  return text + "\n" + printable(diagnosis.verdict()) + "\n";
}

nlohmann::ordered_json toJson(const Diagnosis& diagnosis) {
  nlohmann::ordered_json json = reportHead("candela-doctor/2");
  json["agrees"] = agreement(diagnosis.code());
  json["exitCode"] = static_cast<int>(diagnosis.code());
  json["verdict"] = diagnosis.verdict();
  json["device"] = diagnosis.device ? nlohmann::ordered_json(diagnosis.device->name) : nullptr;
  json["checks"] = nlohmann::ordered_json::array();
  for (const Check& check : diagnosis.checks) json["checks"].push_back(toJson(check));
  json["devices"] = nlohmann::ordered_json(nlohmann::json(diagnosis.devices));
  json["comparison"] = diagnosis.trial ? nlohmann::ordered_json(diagnosis.trial->agreement) : nullptr;
  return json;
}

}  // namespace candela::doctor

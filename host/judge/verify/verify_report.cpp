// The verdict, and the report as text and JSON.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "host/base/report_head.h"
#include "host/base/setting_words.h"
#include "host/judge/verify/verify_answers.h"

namespace candela::verify {
namespace {

using nlohmann::ordered_json;

ordered_json lightJson(const VerifyReport& report) {
  const LightTestResult& light = report.light;
  const bool isOpen = report.doubt() != Doubt::none;
  ordered_json json{{"agrees", isOpen ? ordered_json() : ordered_json(!light.differs())},
                    {"test", report.options.method == LightTestMethod::paired ? "paired" : "independent"},
                    {"bias", light.bias},
                    {"samplesPerPixel", light.samplesPerPixel},
                    {"information", light.information},
                    {"looks", light.looks},
                    {"level", light.level},
                    {"outOfTime", light.outOfTime}};
  for (const RegionResult& result : light.regions) json["regions"].push_back(regionJson(result, "device"));
  return json;
}

// Names the sides that do not have the exact mean, each with its own.
std::string inexactSides(const ExactTest& exact) {
  const auto side = [&](const char* name, double mean) { return fmt::format("{} has {:.4g}", name, mean); };
  std::string sides;
  if (exact.deviceDiffers()) sides = side("the device", exact.device);
  if (exact.referenceDiffers()) sides += (sides.empty() ? "" : " and ") + side("the reference", exact.reference);
  return fmt::format("{} instead of {:.4g}", sides, exact.expected);
}

std::string inexactVerdict(const VerifyReport& report) {
  const ExactTest& exact = *report.exact;
  if (report.doubt() == Doubt::none && exact.deviceDiffers() == exact.referenceDiffers()) {
    return fmt::format(
        "Device and reference agree with each other, but NOT with the exact result that the scene states: {}.",
        inexactSides(exact));
  }
  return fmt::format("NOT the exact result that the scene states: {}.{}", inexactSides(exact),
                     report.doubt() == Doubt::none ? "" : " Whether both have the same light is not decided.");
}

std::string differenceVerdict(const VerifyReport& report) {
  if (report.light.differs()) {
    const RegionResult& most = report.light.mostSignificant();
    if (most.referenceMean == 0) {
      return fmt::format(
          "Device and reference do NOT compute the same light: the {} is {:.3g} on the device and black on "
          "the reference ({}).",
          regionText(most.region), most.deviceMean, pValueText(most.test.pValue));
    }
    return fmt::format("Device and reference do NOT compute the same light: the {} is {:.3f} % {} on the device ({}).",
                       regionText(most.region), 100 * std::abs(most.relativeDifference()),
                       most.test.difference > 0 ? "brighter" : "darker", pValueText(most.test.pValue));
  }
  if (!report.paths.agree()) {
    return fmt::format(
        "Device and reference show no difference in light, but do NOT trace the same paths: {} pixels "
        "differ that single precision can decide.",
        report.paths.decisions.oddDevice);
  }
  return inexactVerdict(report);
}

std::string openExactVerdict(const ExactTest& exact) {
  return fmt::format(
      "Not decided: noise may hide a difference of {:.2g} % from the exact result that the scene states. A longer "
      "{}, or a larger {}, would decide it.",
      100 * exact.detectableBias, settingWords("time-limit"), settingWords("bias"));
}

}  // namespace

Doubt VerifyReport::doubt() const {
  if (light.differs()) return Doubt::none;
  const Doubt doubt = doubtOf(light.image(), options.maxOverlooked());
  const bool isDarkOnPurpose = doubt == Doubt::darkness && exact && exact->expected == 0 && exact->isMet();
  return isDarkOnPurpose ? Doubt::none : doubt;
}

Conclusion VerifyReport::conclusion() const {
  if (!paths.agree() || light.differs() || (exact && !exact->isMet())) return Conclusion::different;
  return doubt() == Doubt::none && !isExactOpen() ? Conclusion::same : Conclusion::undecided;
}

bool VerifyReport::isExactOpen() const {
  return exact && exact->isMet() && exact->expected > 0 &&
         exact->detectableBias > std::max(options.maxOverlooked(), kExactBias);
}

std::string VerifyReport::verdict() const {
  if (interrupted) return "Interrupted: there is no verdict.";
  switch (conclusion()) {
    case Conclusion::different:
      return differenceVerdict(*this);
    case Conclusion::undecided:
      if (doubt() == Doubt::none) return openExactVerdict(*exact);
      return doubtText(doubt(), light.image(), options.maxOverlooked()) +
             remedyText(doubt(), light.image(),
                        light.outOfTime ? "A longer " + settingWords("time-limit")
                        : options.bias  ? "A longer run"
                                        : "The longer run of " + settingWords("bias", "1%"));
    case Conclusion::same:
      break;
  }
  if (light.image().referenceMean == 0) return "Device and reference are both black, as the scene states.";
  return fmt::format(
      "Device and reference compute the same light{}: a difference of {:.2g} % of the image mean would have been "
      "detected with {:.0f} % probability.",
      exact ? ", and it is the exact result" : "", 100 * light.image().detectableBias, 100 * kPower);
}

std::string toText(const VerifyReport& report) {
  std::string text = fmt::format("{}: {} compared with the reference\n", report.scene, report.deviceStatistics.device);
  if (!report.interrupted) text += pathsText(report) + lightText(report) + exactText(report);
  return text + report.verdict() + "\n";
}

ordered_json toJson(const VerifyReport& report) {
  ordered_json json = reportHead("candela-verify/3");
  json["scene"] = report.scene;
  json["device"] = report.deviceStatistics.device;
  json["driver"] = report.deviceStatistics.driver;
  json["interrupted"] = report.interrupted;
  json["agrees"] = report.interrupted ? ordered_json() : agreesJson(report.conclusion());
  json["verdict"] = report.verdict();
  json["alpha"] = report.options.alpha;
  json["bias"] = report.light.bias;
  json["seconds"] = report.seconds;
  if (report.interrupted) return json;
  json["undecided"] = doubtJson(report.doubt(), report.light.image(), report.options.maxOverlooked());
  json["samePaths"] = report.paths.json();
  json["sameLight"] = lightJson(report);
  if (report.exact) {
    json["rightLight"] = {{"agrees", report.isExactOpen() ? ordered_json() : ordered_json(report.exact->isMet())},
                          {"expected", report.exact->expected},
                          {"device", report.exact->device},
                          {"reference", report.exact->reference},
                          {"devicePValue", report.exact->devicePValue},
                          {"referencePValue", report.exact->referencePValue},
                          {"level", report.exact->level},
                          {"detectableBias", report.exact->detectableBias},
                          {"samplesPerPixel", report.exact->samplesPerPixel}};
  }
  return json;
}

}  // namespace candela::verify

// The verdict, and the report as text and JSON.
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "host/core/report_head.h"
#include "host/verify/verify_answers.h"

namespace candela::verify {
namespace {

using nlohmann::ordered_json;

ordered_json lightJson(const LightTestResult& light, const LightTestOptions& options) {
  ordered_json json{{"agrees", !light.differs()},
                    {"test", options.method == LightTestMethod::paired ? "paired" : "independent"},
                    {"bias", light.bias},
                    {"samplesPerPixel", light.samplesPerPixel},
                    {"information", light.information},
                    {"looks", light.looks},
                    {"level", light.level},
                    {"outOfTime", light.outOfTime}};
  for (const RegionResult& result : light.regions) json["regions"].push_back(regionJson(result, "device"));
  return json;
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
  return "Device and reference agree with each other, but NOT with the exact result that the scene states.";
}

// The picture of the reference is black, so that no fraction of its mean could be detected.
std::string blackVerdict(const RegionResult& image) {
  if (image.deviceMean == 0) return "Device and reference are both black: no light was compared. This verdict is weak.";
  return fmt::format(
      "The reference is black, and the device's mean of {:.2g} may be chance: no light was compared. This verdict is "
      "weak.",
      image.deviceMean);
}

}  // namespace

bool VerifyReport::isWeak() const {
  if (!agree()) return false;
  return light.image().referenceMean == 0 || light.image().detectableBias > kWeakBias;
}

std::string VerifyReport::verdict() const {
  if (interrupted) return "Interrupted: there is no verdict.";
  if (!agree()) return differenceVerdict(*this);
  if (light.image().referenceMean == 0) return blackVerdict(light.image());
  const double seen = light.image().detectableBias;
  const std::string limit = light.information < 1 ? " (the run ended before the requested bias could be detected)" : "";
  return fmt::format(
      "Device and reference compute the same light{}: a difference of {:.2g} % of the image mean would have been "
      "detected with {:.0f} % probability{}.{}",
      exact ? ", and it is the exact result" : "", 100 * seen, 100 * kPower, limit,
      isWeak() ? fmt::format(" This verdict is weak: errors of {:.0f} % may have gone unnoticed.", 100 * kWeakBias)
               : "");
}

std::string toText(const VerifyReport& report) {
  std::string text = fmt::format("{}: {} compared with the reference\n", report.scene, report.deviceStatistics.device);
  if (!report.interrupted) text += pathsText(report) + lightText(report) + exactText(report);
  return text + report.verdict() + "\n";
}

ordered_json toJson(const VerifyReport& report) {
  ordered_json json = reportHead("candela-verify/2");
  json["scene"] = report.scene;
  json["device"] = report.deviceStatistics.device;
  json["driver"] = report.deviceStatistics.driver;
  json["interrupted"] = report.interrupted;
  json["agrees"] = report.interrupted ? ordered_json() : ordered_json(report.agree());
  json["weak"] = report.interrupted ? ordered_json() : ordered_json(report.isWeak());
  json["verdict"] = report.verdict();
  json["alpha"] = report.options.alpha;
  json["bias"] = report.light.bias;
  json["seconds"] = report.seconds;
  if (report.interrupted) return json;
  json["samePaths"] = report.paths.json();
  json["sameLight"] = lightJson(report.light, report.options);
  if (report.exact) {
    json["rightLight"] = {{"agrees", report.exact->isMet()},
                          {"expected", report.exact->expected},
                          {"device", report.exact->device},
                          {"reference", report.exact->reference},
                          {"devicePValue", report.exact->devicePValue},
                          {"referencePValue", report.exact->referencePValue},
                          {"level", report.exact->level},
                          {"samplesPerPixel", report.exact->samplesPerPixel}};
  }
  return json;
}

}  // namespace candela::verify

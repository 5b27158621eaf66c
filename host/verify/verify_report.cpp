// Formats the verdict as text, JSON and JUnit XML.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "host/core/markup.h"
#include "host/core/report_head.h"
#include "host/verify/verify.h"

namespace candela::verify {
namespace {

using nlohmann::ordered_json;

std::size_t differingTiles(const LightTestResult& light) {
  std::size_t count = 0;
  for (const RegionResult& result : light.regions) count += result.differs && result.region.tileSize > 0 ? 1 : 0;
  return count;
}

std::string pathsText(const VerifyReport& report) {
  const PixelAgreement& paths = report.paths;
  std::string text = fmt::format("1 Same numbers, same paths?  {}: {}\n",
                                 !paths.decisions.isPossible ? "not asked"
                                 : paths.agree()             ? "yes"
                                                             : "NO",
                                 paths.decisions.summary());
  for (const std::string& line : paths.decisions.details()) text += fmt::format("{:29}{}\n", "", line);
  return text + fmt::format(
                    "                             {:.3f} % of {} pixels are equal to {:.0e}\n"
                    "                             first differences of the others:{}\n",
                    100 * paths.equalFraction(), paths.pixels, kRelativeTolerance, paths.causesText());
}

std::string lightText(const VerifyReport& report) {
  const LightTestResult& light = report.light;
  std::string text = fmt::format(
      "2 Same light?                {}: {} samples per pixel on each side, {} look{}, {} tests at p < {:.1e}\n",
      light.differs() ? "NO" : "yes", light.samplesPerPixel, light.looks, light.looks == 1 ? "" : "s",
      light.regions.size(), light.level);
  text += fmt::format("                             {}\n", differenceText(light.image()));
  const RegionResult& most = light.mostSignificant();
  if (&most != &light.image()) text += fmt::format("                             {}\n", differenceText(most));
  if (const std::size_t tiles = differingTiles(light))
    text += fmt::format("                             {} tiles differ\n", tiles);
  if (light.badSamples.samples() > 0)
    text += fmt::format("                             {} bad samples\n", light.badSamples.samples());
  return text;
}

std::string exactText(const VerifyReport& report) {
  if (!report.exact) return "3 Right light?               the scene does not state an exact result\n";
  const ExactTest& exact = *report.exact;
  std::string text = fmt::format(
      "3 Right light?               {}: exact {:.6g}, device {:.6g} (p = {:.1e}), reference {:.6g} (p = {:.1e})\n",
      exact.isMet() ? "yes" : "NO", exact.expected, exact.device, exact.devicePValue, exact.reference,
      exact.referencePValue);
  if (exact.samplesPerPixel == 0) return text;
  return text +
         fmt::format("                             {} more samples per pixel on the device\n", exact.samplesPerPixel);
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

struct JunitCase {
  std::string name;
  bool passed;
  std::string text;  ///< of a failure
};

std::string toXml(const JunitCase& junitCase) {
  const std::string head = fmt::format("  <testcase classname=\"candela.verify\" name=\"{}\"",
                                       xmlEscaped(junitCase.name));
  if (junitCase.passed) return head + "/>\n";
  return fmt::format("{}>\n    {}\n  </testcase>\n", head, junitFailure("Fail", junitCase.text));
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

std::string toJunit(const VerifyReport& report, bool strict) {
  std::vector<JunitCase> cases{
      {"same numbers, same paths", report.paths.agree(), report.interrupted ? report.verdict() : pathsText(report)},
      {"same light", !report.interrupted && !report.light.differs(), report.verdict()}};
  if (report.exact) cases.push_back({"right light", report.exact->isMet(), exactText(report)});
  if (strict) {
    cases.push_back({"no bad samples", report.badSamples.samples() == 0,
                     fmt::format("{} bad samples", report.badSamples.samples())});
  }
  const auto failures = std::count_if(cases.begin(), cases.end(), [](const JunitCase& c) { return !c.passed; });
  std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  xml += fmt::format("<testsuite name=\"candela verify {}\" tests=\"{}\" failures=\"{}\" time=\"{:.3f}\">\n",
                     xmlEscaped(report.scene), cases.size(), failures, report.seconds);
  for (const JunitCase& junitCase : cases) xml += toXml(junitCase);
  return xml + "</testsuite>\n";
}

}  // namespace candela::verify

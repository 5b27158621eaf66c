// The result of the test of two sets of renders as text and as JSON.
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "host/base/counted.h"
#include "host/base/setting_words.h"
#include "host/judge/verify/render_set_test.h"

namespace candela::verify {
namespace {

const SideNames kSetNames{"A", "B"};

// "0.97 % darker (95 % confidence: 0.85 % to 1.1 % darker)"
std::string intervalText(const RegionResult& result) {
  if (result.referenceMean == 0) return fmt::format("{:.6g}, and B is 0", result.deviceMean);
  const RelativeDifference relative = relativeDifferenceOf(result);
  if (std::isinf(relative.high)) return fmt::format("{:+.3g} %, with an unknown error", 100 * relative.value);
  return fmt::format("{:+.3g} % (95 % confidence: {:+.3g} % to {:+.3g} %)", 100 * relative.value, 100 * relative.low,
                     100 * relative.high);
}

std::string lineOf(const RegionResult& result) {
  return fmt::format("                      {}: A {:.6g}, B {:.6g}: {}, p = {:.2g}\n", regionText(result.region),
                     result.deviceMean, result.referenceMean, intervalText(result), result.test.pValue);
}

std::string setsText(const SetTestResult& result) {
  if (result.options.design == SetDesign::paired) return counted(result.countA, "pair");
  if (result.options.design == SetDesign::picture)
    return counted(result.countA, "render") + " of A and one picture with variances";
  return fmt::format("{} of A and {} of B", counted(result.countA, "render"), result.countB);
}

std::string fewRendersText(const SetTestResult& result) {
  const std::size_t needed = minRenders(result.options.design, result.options.alpha);
  return fmt::format(
      "Not decided: the p-value of {} is at least {:.2g}, and the level is {:g}. {}, or a larger {}, would decide it.",
      setsText(result), result.minPValue, result.options.alpha,
      result.options.design == SetDesign::paired ? fmt::format("At least {} pairs", needed)
                                                 : fmt::format("At least {} renders on each side", needed),
      settingWords("alpha"));
}

std::string precisionText(const SetTestResult& result) {
  return fmt::format(
      "Not decided: the files round their values to {} bits, which may hide {:.2g} % of the image mean, and at most "
      "{:.2g} % may be hidden. EXR files of 32 bits, or a larger {}, would decide it.",
      result.significandBits, 100 * result.image().relative(result.image().excused), 100 * result.options.maxOverlooked,
      settingWords("bias"));
}

const char* answerOf(Conclusion conclusion) {
  switch (conclusion) {
    case Conclusion::same:
      return "yes";
    case Conclusion::different:
      return "NO";
    case Conclusion::undecided:
      break;
  }
  return "not decided";
}

nlohmann::ordered_json regionOf(const RegionResult& result) {
  nlohmann::ordered_json json = regionJson(result, "mean");
  if (result.referenceMean == 0) return json;
  const RelativeDifference relative = relativeDifferenceOf(result);
  json["differenceFraction"] = relative.value;
  json["differenceLowFraction"] = relative.low;
  json["differenceHighFraction"] = relative.high;
  return json;
}

}  // namespace

std::string SetTestResult::verdict() const {
  if (differs()) {
    const RegionResult& most = mostSignificant();
    return fmt::format(
        "A and B do NOT show the same light: the {} of A differs from B by {}; p = {:.2g} over all tests.",
        regionText(most.region), intervalText(most), pValue);
  }
  if (hasEqualPairs) return "A and B show the same light: the renders of each pair are equal.";
  switch (doubt()) {
    case Doubt::renders:
      return fewRendersText(*this);
    case Doubt::rounding:
      return precisionText(*this);
    case Doubt::none:
      return fmt::format(
          "A and B show the same light within their noise: a difference of {:.2g} % of the image mean would have been "
          "detected with {:.0f} % probability.",
          100 * image().detectableBias, 100 * kPower);
    default:
      return doubtText(doubt(), image(), options.maxOverlooked, kSetNames) +
             remedyText(doubt(), image(), "More renders, or more samples in each");
  }
}

std::string toText(const SetTestResult& result) {
  std::string text = fmt::format("same light?           {}: {}, {} tests together: p = {:.2g}, level {:g}\n",
                                 answerOf(result.conclusion()), setsText(result), result.regions.size(), result.pValue,
                                 result.options.alpha);
  text += lineOf(result.image());
  const RegionResult& most = result.mostSignificant();
  if (&most != &result.image()) text += lineOf(most);
  return text + result.verdict() + "\n";
}

nlohmann::ordered_json toJson(const SetTestResult& result) {
  nlohmann::ordered_json json{{"agrees", agreesJson(result.conclusion())},
                              {"verdict", result.verdict()},
                              {"undecided", doubtJson(result.doubt(), result.image(), result.options.maxOverlooked)},
                              {"design", kSetDesignNames[static_cast<std::size_t>(result.options.design)]},
                              {"rendersOfA", result.countA},
                              {"rendersOfB", result.countB},
                              {"alpha", result.options.alpha},
                              {"pValue", result.pValue}};
  if (result.options.design != SetDesign::picture) {
    json["minPValue"] = result.minPValue;
    json["divisions"] = result.divisions;
    json["allDivisions"] = result.isExhaustive;
  }
  for (const RegionResult& region : result.regions) json["regions"].push_back(regionOf(region));
  return json;
}

}  // namespace candela::verify

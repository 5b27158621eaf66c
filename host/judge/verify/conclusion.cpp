// Judges what a comparison may have overlooked.
#include "host/judge/verify/conclusion.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "host/base/setting_words.h"

namespace candela::verify {
namespace {

// A difference of this number of standard errors is not noise.
constexpr double kClearErrors = 3;
// A limit of this multiple of what is excused leaves room for noise.
constexpr double kAcceptance = 1.5;
// Replicas lose the same light if they lose at least this fraction of it. They take the other decision in half of the
// cases in which a device may always take it, and may thus lose half as much.
constexpr double kFractionOfIt = 0.25;

std::string percent(double fraction) {
  return fraction < 0.995 ? fmt::format("{:.2g} %", 100 * fraction) : fmt::format("{:.0f} %", 100 * fraction);
}

// The size of what may be hidden; there is none if the test has too few values.
std::string sizeText(double fraction) {
  return std::isfinite(fraction) ? "a difference of " + percent(fraction) + " of the image mean"
                                 : "a difference of any size";
}

std::string leanText(const RegionResult& image, const SideNames& names) {
  const double lean = image.relativeDifference();
  std::string text = fmt::format(" {} is {} {} than {} (standard error {})", names.first, percent(std::abs(lean)),
                                 lean < 0 ? "darker" : "brighter", names.second,
                                 percent(image.relative(image.test.standardError)));
  if (isLostBySinglePrecision(image)) {
    text += fmt::format(
        "; replicas with perturbed arithmetic are {} {} than exact arithmetic, too, so that single precision {} this "
        "light",
        percent(std::abs(image.relative(image.replicaDifference))), lean < 0 ? "darker" : "brighter",
        lean < 0 ? "loses" : "adds");
  }
  return text + ".";
}

std::string darknessText(const RegionResult& image, const SideNames& names) {
  if (image.deviceMean == 0)
    return fmt::format("{} and {} are both black: no light was compared.", names.first, names.second);
  return fmt::format("{} has a mean of {:.2g}, which may be noise, and {} is black: no light was compared.",
                     names.first, image.deviceMean, names.second);
}

// Names the option that accepts what is excused; nothing if that is about the whole mean.
std::string acceptanceText(const RegionResult& image) {
  const double accepted = kAcceptance * image.relative(image.excused);
  return accepted < 1
             ? fmt::format("; {} accepts what is excused", settingWords("bias", fmt::format("{:.2g}%", 100 * accepted)))
             : "";
}

}  // namespace

Doubt doubtOf(const RegionResult& image, double maxOverlooked) {
  if (image.referenceMean == 0) return Doubt::darkness;
  if (image.relative(image.excused) > maxOverlooked) return Doubt::rounding;
  return image.detectableBias > maxOverlooked ? Doubt::noise : Doubt::none;
}

bool isLostBySinglePrecision(const RegionResult& image) {
  const double lean = image.test.difference;
  const double replicas = image.replicaDifference;
  return lean * replicas > 0 && std::abs(lean) > kClearErrors * image.test.standardError &&
         std::abs(replicas) > kClearErrors * image.replicaStandardError &&
         std::abs(replicas) >= kFractionOfIt * std::abs(lean);
}

std::string doubtText(Doubt doubt, const RegionResult& image, double maxOverlooked, const SideNames& names) {
  const std::string limit = percent(maxOverlooked);
  switch (doubt) {
    case Doubt::none:
    case Doubt::renders:
      return "";
    case Doubt::rounding:
      return fmt::format("Not decided: rounding in single precision excuses {}, and at most {} may be excused.{}",
                         sizeText(image.relative(image.excused)), limit, leanText(image, names));
    case Doubt::noise:
      return fmt::format("Not decided: noise may hide {}, and at most {} may be hidden.{}",
                         sizeText(image.detectableBias), limit, leanText(image, names));
    case Doubt::darkness:
      break;
  }
  return "Not decided: " + darknessText(image, names);
}

std::string remedyText(Doubt doubt, const RegionResult& image, const std::string& moreSamples) {
  switch (doubt) {
    case Doubt::none:
    case Doubt::renders:
      return "";
    case Doubt::rounding:
      return " Remove or separate surfaces that coincide, or move the scene to its origin" + acceptanceText(image) +
             ".";
    case Doubt::noise:
      return fmt::format(" {}, or a larger {}, would decide it.", moreSamples, settingWords("bias"));
    case Doubt::darkness:
      break;
  }
  return fmt::format(" Give the scene light, for example by {}.", settingWords("env", "white"));
}

nlohmann::ordered_json agreesJson(Conclusion conclusion) {
  if (conclusion == Conclusion::undecided) return nullptr;
  return conclusion == Conclusion::same;
}

nlohmann::ordered_json doubtJson(Doubt doubt, const RegionResult& image, double maxOverlooked) {
  if (doubt == Doubt::none) return nullptr;
  nlohmann::ordered_json json{{"reason", kDoubtNames[static_cast<std::size_t>(doubt)]},
                              {"maxOverlookedFraction", maxOverlooked}};
  if (doubt == Doubt::darkness) return json;
  json["overlookedFraction"] = image.detectableBias;
  json["excusedFraction"] = image.relative(image.excused);
  json["differenceFraction"] = image.relativeDifference();
  json["replicaDifferenceFraction"] = image.relative(image.replicaDifference);
  json["lostBySinglePrecision"] = isLostBySinglePrecision(image);
  return json;
}

}  // namespace candela::verify

// The result of the test of decisions as text and as JSON.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "host/judge/verify/decisions.h"

namespace candela::verify {

std::string DecisionTest::summary() const {
  if (!isPossible) return "the reference traced no replicas, so only the test for equal light decides";
  const std::uint64_t decidable = pixels - undecidable;
  if (odd == 0) return fmt::format("all {} pixels that single precision can decide agree", decidable);
  return fmt::format("of {} pixels that single precision can decide, {} differ on the device alone", decidable,
                     oddDevice);
}

std::vector<std::string> DecisionTest::details() const {
  if (!isPossible) return {};
  std::string undecided = fmt::format("{:.3g} % of {} pixels cannot be decided in single precision",
                                      100 * undecidableFraction(), pixels);
  if (undecidable > 0) undecided += fmt::format(" (amplification up to {:.1e} at vertex {})", amplification, vertex);
  return {undecided, fmt::format("among the others, the device's value is the outlier in {}, a replica's in {} "
                                 "(p = {:.1e})",
                                 oddDevice, odd - oddDevice, pValue)};
}

std::string DecisionTest::text() const {
  return isPossible ? fmt::format("{}", fmt::join(details(), "; ")) : summary();
}

nlohmann::ordered_json DecisionTest::json() const {
  return {{"agrees", isPossible ? nlohmann::ordered_json(agrees()) : nlohmann::ordered_json()},
          {"possible", isPossible},
          {"undecidable", undecidable},
          {"undecidableFraction", undecidableFraction()},
          {"amplification", amplification},
          {"amplificationVertex", vertex},
          {"replicas", kReplicas},
          {"candidates", candidates},
          {"odd", odd},
          {"oddDevice", oddDevice},
          {"pValue", pValue},
          {"level", level}};
}

}  // namespace candela::verify

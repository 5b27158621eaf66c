// Tests the means of one region, and formats the result.
#include "host/judge/verify/region_result.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "host/judge/verify/agreement.h"
#include "host/trace/render/extent.h"

namespace candela::verify {

double RegionResult::relativeDifference() const {
  return referenceMean == 0 ? test.difference : test.difference / std::abs(referenceMean);
}

RegionResult compareRegion(const Region& region, const statistics::Estimate& device,
                           const statistics::Estimate& reference, double level, double excused) {
  const double rounding = std::max(excused, kRelativeTolerance * std::abs(reference.mean) + kAbsoluteTolerance);
  RegionResult result{region,   device.mean, reference.mean, statistics::welch(device, reference, rounding),
                      rounding, rounding};
  result.differs = result.test.pValue < level;
  if (reference.mean == 0) return result;
  result.detectableBias = result.relative(rounding);
  if (result.test.standardError == 0) return result;
  const double critical = statistics::criticalT(level, result.test.degreesOfFreedom);
  result.detectableBias += result.relative((critical + statistics::normalQuantile(kPower)) * result.test.standardError);
  return result;
}

bool RegionTests::differs() const { return std::ranges::any_of(regions, &RegionResult::differs); }

const RegionResult& RegionTests::mostSignificant() const {
  if (image().differs) return image();
  // Adjusted p-values are often equal.
  const auto rankOf = [](const RegionResult& result) { return std::pair(result.test.pValue, -result.test.t); };
  const RegionResult& least = *std::ranges::min_element(regions, {}, rankOf);
  return least.differs ? least : image();
}

std::string pValueText(double pValue) { return pValue > 0 ? fmt::format("p = {:.1e}", pValue) : "p < 1e-300"; }

std::string differenceText(const RegionResult& result) {
  if (result.referenceMean == 0) {
    return fmt::format("{}: {:.6g}, reference 0 (standard error {:.2g}, p = {:.1e})", regionText(result.region),
                       result.deviceMean, result.test.standardError, result.test.pValue);
  }
  const double error = result.test.standardError / std::abs(result.referenceMean);
  return fmt::format("{}: {:.6g}, reference {:.6g}, {:+.2g} % (standard error {:.2g} %, p = {:.1e})",
                     regionText(result.region), result.deviceMean, result.referenceMean,
                     100 * result.relativeDifference(), 100 * error, result.test.pValue);
}

nlohmann::ordered_json regionJson(const RegionResult& result, const char* firstName) {
  return {{"window", render::windowText({result.region.x, result.region.y, result.region.width, result.region.height})},
          {"tileSize", result.region.tileSize},
          {"quantity", quantityName(result.region.quantity)},
          {firstName, result.deviceMean},
          {"reference", result.referenceMean},
          {"difference", result.test.difference},
          {"margin", result.margin},
          {"excused", result.excused},
          {"replicaDifference", result.replicaDifference},
          {"replicaStandardError", result.replicaStandardError},
          {"standardError", result.test.standardError},
          {"degreesOfFreedom", result.test.degreesOfFreedom},
          {"t", result.test.t},
          {"pValue", result.test.pValue},
          {"detectableBias", result.detectableBias},
          {"agrees", !result.differs}};
}

}  // namespace candela::verify

// One region of two pictures: both means, and whether chance explains that they are not equal.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "host/statistics/welch.h"
#include "host/verify/regions.h"

namespace candela::verify {

/// With which a bias that is called detectable is seen.
inline constexpr double kPower = 0.99;

/// The device's picture, or the one in question, against the reference's.
struct RegionResult {
  Region region;
  double deviceMean = 0;
  double referenceMean = 0;
  statistics::WelchTest test;
  double detectableBias = 0;  ///< relative to the reference's mean: seen with probability kPower; 0 where that is black
  bool differs = false;

  /// Signed, of the reference's mean; the whole difference where that is black.
  double relativeDifference() const;
};

/// Tests one region at `level`. What single precision rounds away (kRelativeTolerance of the mean) is no difference.
RegionResult compareRegion(const Region& region, const statistics::Estimate& device,
                           const statistics::Estimate& reference, double level);

bool anyDiffers(std::span<const RegionResult> results);
/// Of results of which the first is the whole image by luminance: that one if it differs, else the region that differs
/// most significantly, else the image again.
const RegionResult& mostSignificant(std::span<const RegionResult> results);

/// "p = 1.2e-05", or "p < 1e-300" if `pValue` is 0.
std::string pValueText(double pValue);
/// Both means, their difference with its standard error, and p.
std::string differenceText(const RegionResult& result);
/// All figures; the mean of the picture in question is called `firstName`.
nlohmann::ordered_json regionJson(const RegionResult& result, const char* firstName);

}  // namespace candela::verify

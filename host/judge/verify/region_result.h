// The comparison of one region of two images: both means, and the test of their difference.
#pragma once
#include <cmath>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "host/base/statistics/welch.h"
#include "host/judge/verify/regions.h"

namespace candela::verify {

/// Probability with which a detectable bias is detected.
inline constexpr double kPower = 0.99;

/// The device's image, or the image under test, compared with the reference.
struct RegionResult {
  Region region;
  double deviceMean = 0;
  double referenceMean = 0;
  statistics::WelchTest test;
  double margin = 0;   ///< difference that rounding may cause
  double excused = 0;  ///< largest difference that is attributed to rounding: the margin, and the drift of replicas
  double replicaDifference = 0;     ///< of replicas from the exact samples
  double replicaStandardError = 0;  ///< of replicaDifference
  /// Relative to the reference's mean, detected with probability kPower; 0 if that mean is 0; infinite if the test has
  /// too few values to find any difference.
  double detectableBias = 0;
  bool differs = false;

  /// Returns the signed difference as a fraction of the reference's mean; the difference itself if that mean is 0.
  double relativeDifference() const;
  /// Returns `amount` as a fraction of the magnitude of the reference's mean, which must not be 0.
  double relative(double amount) const { return amount / std::abs(referenceMean); }
};

/// Tests one region at `level`. Differences within the rounding of single precision (kRelativeTolerance of the mean),
/// and up to `excused`, do not count.
RegionResult compareRegion(const Region& region, const statistics::Estimate& device,
                           const statistics::Estimate& reference, double level, double excused = 0);

/// The tests of all regions of two images.
struct RegionTests {
  double level = 0;                   ///< level of each region's test, or of one that would stand alone: see isAdjusted
  std::vector<RegionResult> regions;  ///< the luminance of the whole image first
  bool isAdjusted = false;            ///< p-values are adjusted for all regions, which `level` does not judge

  bool differs() const;
  /// Returns the result of the whole image. The list must not be empty.
  const RegionResult& image() const { return regions.front(); }
  /// Returns the result of the whole image if it differs, else the one that differs most significantly, else that of
  /// the whole image. The list must not be empty.
  const RegionResult& mostSignificant() const;
};

/// Returns "p = 1.2e-05", or "p < 1e-300" if `pValue` is 0.
std::string pValueText(double pValue);
/// Returns both means, their difference with its standard error, and p.
std::string differenceText(const RegionResult& result);
/// Returns all figures. The key of the first mean is `firstName`.
nlohmann::ordered_json regionJson(const RegionResult& result, const char* firstName);

}  // namespace candela::verify

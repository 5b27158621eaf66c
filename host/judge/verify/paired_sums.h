// Sums of the paired differences of both tracers over the pixels of a region.
//
// Device and reference draw the same random numbers. Let d be the sum of the differences of a pixel's samples, e that
// of a replica's |differences| from the exact sample, and f the sum of the replica's differences in samples whose
// errors are amplified (docs/testing.md). The values tested are d - f - 2 e and f - d - 2 e, one for each pixel and
// batch: their means are at most 0 where the device's rounding is no worse than a replica's.
#pragma once
#include <span>
#include <vector>

#include "host/base/statistics/self_normalised.h"
#include "host/image/film.h"
#include "host/judge/verify/decisions.h"
#include "host/judge/verify/region_result.h"
#include "host/trace/render/session.h"

namespace candela::verify {

/// The device may decide, wherever rounding can, always the other way; replicas do in half of the cases.
inline constexpr double kOneWay = 2;
/// The drift of replicas counts as an excuse where it exceeds this number of standard errors; below, it is noise.
inline constexpr double kDriftErrors = 3;

struct PairedSum {
  statistics::SelfNormalisedSum brighter, darker;
  double device = 0;                      ///< sum of all samples
  double reference = 0;                   ///< the same of the reference
  double margin = 0;                      ///< kOneWay times the sum of e
  double drift = 0;                       ///< the sum of f
  statistics::SelfNormalisedSum replica;  ///< differences of the replica from the exact samples
  double samples = 0;                     ///< number of samples, of all pixels
};

/// Returns the deviations of the session's replicas so far, one per pixel; empty if it traces none.
std::vector<render::Deviation> deviationsOf(render::Session& session);

class PairedSums {
 public:
  /// `regions` must outlive the object. `scale`: see statistics::evidence().
  PairedSums(std::span<const Region> regions, double scale);

  /// Adds a batch of both tracers with equal numbers of samples in all pixels. `deviations` of the reference, one per
  /// pixel; empty: none.
  void add(const image::Film& device, const image::Film& reference, std::span<const render::Deviation> deviations);

  /// Tests a region at `level`, two-sided, for all looks together.
  RegionResult test(std::size_t region, double level) const;
  /// Returns the fraction of the information that is needed to detect `bias` with probability kPower, in [0, 1]: 0 if
  /// the bias is below what rounding excuses.
  double information(std::size_t region, double bias, double level) const;
  const PairedSum& at(std::size_t region) const { return sums_[region]; }

 private:
  /// Returns the sum that exceeds the critical one with probability kPower; infinite if so few equal values never do.
  double neededSum(const PairedSum& sum, double level) const;
  double neededSumOfEqualValues(std::uint64_t count, double level) const;

  std::span<const Region> regions_;
  double scale_;
  std::vector<PairedSum> sums_;
};

}  // namespace candela::verify

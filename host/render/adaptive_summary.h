// What adaptive sampling did to a film.
#pragma once
#include <cstdint>
#include <map>

#include "host/render/adaptive_plan.h"

namespace candela::render {

struct AdaptiveSummary {
  std::uint32_t minSamples = 0, maxSamples = 0;  ///< of a pixel
  double meanSamples = 0;
  std::map<std::uint32_t, std::uint32_t> halfRegions;  ///< number of half-regions by samples of their pixels
  /// Estimates of the relative errors of half-regions from the other halves: root of the mean of squares, and maximum.
  /// Half-regions without an estimate do not count.
  double meanError = 0, maxError = 0;
};

/// Describes a film that was sampled by `plan`.
AdaptiveSummary summarise(const AdaptivePlan& plan, const image::Film& film);

}  // namespace candela::render

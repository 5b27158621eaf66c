// Describes the samples that adaptive sampling gave to a film.
#pragma once
#include <cstdint>
#include <map>

#include "host/trace/render/adaptive_plan.h"

namespace candela::render {

/// Numbers of samples of the pixels of a film.
struct SampleCounts {
  std::uint32_t minSamples = 0, maxSamples = 0;
  double meanSamples = 0;
};

struct AdaptiveSummary : SampleCounts {
  std::map<std::uint32_t, std::uint32_t> halfRegions;  ///< number of half-regions by samples of their pixels
  /// Estimates of the relative errors of half-regions from the other halves: root of the mean of squares, and maximum.
  /// Half-regions without an estimate do not count.
  double meanError = 0, maxError = 0;
};

/// The film has a pixel.
SampleCounts sampleCountsOf(const image::Film& film);

/// Describes a film that was sampled by `plan`.
AdaptiveSummary summarise(const AdaptivePlan& plan, const image::Film& film);

}  // namespace candela::render

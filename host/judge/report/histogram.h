// Histograms of values and of differences.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "host/image/image.h"

namespace candela::report {

/// Counts in equal bins from `low` to `high`. Values outside are counted in the first or last bin.
struct Histogram {
  double low = 0;
  double high = 1;
  std::vector<std::uint64_t> counts;
  std::uint64_t leftOut = 0;  ///< number of values that are not finite, or that have no logarithm

  /// Requires low < high.
  Histogram(double lowest, double highest, std::size_t bins) : low(lowest), high(highest), counts(bins) {}
  void add(double value);
};

/// Returns histograms of log2 of the luminances of both images with common bins: two per stop, over at most 24 stops up
/// to the highest whole stop.
struct ValueHistograms {
  Histogram a;
  Histogram b;
};
ValueHistograms valueHistograms(const image::Image& a, const image::Image& b);

/// Returns the histogram of (a - b) / (b + 1 % of the mean of b) of the luminances, as in the difference map. Its range
/// is the smallest of +-0.1 %, 1 %, 10 %, 100 % and 1000 % that contains 99 % of the pixels.
Histogram differenceHistogram(const image::Image& a, const image::Image& b);

}  // namespace candela::report

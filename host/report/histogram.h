// How often values and differences occur.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "host/image/image.h"

namespace candela::report {

/// Counts in equal bins from `low` to `high`; what lies outside counts in the first or last bin.
struct Histogram {
  double low = 0;
  double high = 1;
  std::vector<std::uint64_t> counts;
  std::uint64_t leftOut = 0;  ///< values that are not finite, or of which there is no logarithm

  /// Of low < high.
  Histogram(double lowest, double highest, std::size_t bins) : low(lowest), high(highest), counts(bins) {}
  void add(double value);
};

/// log2 of the luminances of both images, over common bins: two a stop, from the highest whole stop down by at most 24.
struct ValueHistograms {
  Histogram a;
  Histogram b;
};
ValueHistograms valueHistograms(const image::Image& a, const image::Image& b);

/// (a - b) / (b + 1 % of b's mean) of the luminances, as the difference map shows them, over the smallest of +-0.1 %,
/// 1 %, 10 %, 100 % and 1000 % in which 99 % of the pixels lie.
Histogram differenceHistogram(const image::Image& a, const image::Image& b);

}  // namespace candela::report

// Statistics of regions, from the sums of a film.
#include "host/trace/render/adaptive_regions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace candela::render {
namespace {

constexpr std::uint32_t kBlockRegions = kBlockSide / kRegionSide;
constexpr double kDarkness = 0.01;  // as in relMSE

/// Sums over the pixels of one half of a cell.
struct Cell {
  std::uint32_t pixels = 0;
  double variance = 0;
  double luminance = 0;
};

void addTo(HalfStatistics& half, const Cell& cell) {
  if (cell.pixels == 0) return;
  const double mean = cell.luminance / cell.pixels;
  half.pixels += cell.pixels;
  half.relativeVariance += cell.variance / (mean * mean + kDarkness);
}

// The indices of regions, along one axis with `count` of them, that smoothing at `index` uses.
struct IndexRange {
  std::uint32_t first, end;
};

IndexRange smoothedRange(std::uint32_t index, std::uint32_t count) {
  const std::uint32_t block = index - index % kBlockRegions;
  return {std::max(block, index - std::min(index, kSmoothingReach)),
          std::min({block + kBlockRegions, index + kSmoothingReach + 1, count})};
}

// Square roots are correctly rounded everywhere, unlike std::pow().
double eighthRoot(double value) { return std::sqrt(std::sqrt(std::sqrt(value))); }

double fourthPower(double value) {
  const double square = value * value;
  return square * square;
}

}  // namespace

double HalfStatistics::meanVariance() const {
  return pixels < kMinPixels ? std::numeric_limits<double>::infinity() : relativeVariance / pixels;
}

AdaptiveRegions::AdaptiveRegions(const Window& window)
    : window_(window), across_(divideUp(window.width, kRegionSide)), down_(divideUp(window.height, kRegionSide)) {}

void AdaptiveRegions::addCell(const image::Film& film, std::uint32_t left, std::uint32_t top,
                              std::vector<HalfStatistics>& statistics) const {
  std::array<Cell, 2> cells;
  for (std::uint32_t y = top; y < std::min(top + kCellSide, film.height()); ++y) {
    for (std::uint32_t x = left; x < std::min(left + kCellSide, film.width()); ++x) {
      Cell& cell = cells[halfOf(window_.x + x, window_.y + y)];
      ++cell.pixels;
      cell.variance += film.luminanceVariance(x, y);
      cell.luminance += image::luminance(film.mean(x, y));
    }
  }
  for (std::size_t half = 0; half < 2; ++half) addTo(statistics[2 * regionAt(left, top) + half], cells[half]);
}

std::vector<HalfStatistics> AdaptiveRegions::statisticsOf(const image::Film& film) const {
  std::vector<HalfStatistics> statistics(halfRegionCount());
  for (std::uint32_t top = 0; top < film.height(); top += kCellSide) {
    for (std::uint32_t left = 0; left < film.width(); left += kCellSide) addCell(film, left, top, statistics);
  }
  return statistics;
}

std::vector<std::uint32_t> AdaptiveRegions::countsOf(const image::Film& film) const {
  std::vector<std::uint32_t> counts(halfRegionCount());
  for (std::uint32_t y = 0; y < film.height(); ++y) {
    for (std::uint32_t x = 0; x < film.width(); ++x) {
      std::uint32_t& count = counts[halfRegionAt(x, y)];
      count = std::max(count, film.at(x, y).sampleCount);
    }
  }
  return counts;
}

std::vector<double> AdaptiveRegions::variancesOf(const image::Film& film) const {
  const std::vector<HalfStatistics> statistics = statisticsOf(film);
  std::vector<double> variances(statistics.size());
  for (std::size_t i = 0; i < variances.size(); ++i) variances[i] = statistics[i ^ 1].meanVariance();
  return variances;
}

double AdaptiveRegions::smoothedDeviation(const std::vector<double>& variances, std::uint32_t x, std::uint32_t y,
                                          std::size_t half) const {
  const IndexRange rows = smoothedRange(y, down_), columns = smoothedRange(x, across_);
  double sum = 0, weights = 0;
  for (std::uint32_t v = rows.first; v < rows.end; ++v) {
    for (std::uint32_t u = columns.first; u < columns.end; ++u) {
      const double variance = variances[2 * (std::size_t{v} * across_ + u) + half];
      if (std::isinf(variance)) continue;
      const double weight = u == x && v == y ? 1 : kNeighbourWeight;
      sum += weight * eighthRoot(variance);
      weights += weight;
    }
  }
  return weights == 0 ? std::numeric_limits<double>::infinity() : fourthPower(sum / weights);
}

std::vector<double> AdaptiveRegions::smoothedDeviations(const std::vector<double>& variances) const {
  std::vector<double> deviations(variances.size());
  for (std::uint32_t y = 0; y < down_; ++y) {
    for (std::uint32_t x = 0; x < across_; ++x) {
      for (std::size_t half = 0; half < 2; ++half) {
        deviations[2 * (std::size_t{y} * across_ + x) + half] = smoothedDeviation(variances, x, y, half);
      }
    }
  }
  return deviations;
}

}  // namespace candela::render

// Statistics of regions, from the sums of a film.
#include "host/render/adaptive_regions.h"

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

bool areInOneBlock(std::uint32_t a, std::uint32_t b) { return a / kBlockRegions == b / kBlockRegions; }

}  // namespace

double HalfStatistics::relativeError(std::uint32_t samples) const {
  if (pixels < kMinPixels) return std::numeric_limits<double>::infinity();
  return std::sqrt(relativeVariance / pixels / samples);
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

std::vector<double> AdaptiveRegions::errorsOf(const image::Film& film, const std::vector<std::uint32_t>& counts) const {
  const std::vector<HalfStatistics> statistics = statisticsOf(film);
  std::vector<double> errors(counts.size());
  for (std::size_t i = 0; i < errors.size(); ++i) errors[i] = statistics[i ^ 1].relativeError(counts[i]);
  return errors;
}

std::vector<bool> AdaptiveRegions::dilated(const std::vector<bool>& halfRegions) const {
  std::vector<bool> result(halfRegions.size());
  for (std::uint32_t y = 0; y < down_; ++y) {
    for (std::uint32_t x = 0; x < across_; ++x) {
      for (std::uint32_t v = y - (y > 0 ? 1 : 0); v <= std::min(y + 1, down_ - 1); ++v) {
        for (std::uint32_t u = x - (x > 0 ? 1 : 0); u <= std::min(x + 1, across_ - 1); ++u) {
          if (!areInOneBlock(x, u) || !areInOneBlock(y, v)) continue;
          for (std::size_t half = 0; half < 2; ++half) {
            const bool isSet = halfRegions[2 * (std::size_t{v} * across_ + u) + half];
            if (isSet) result[2 * (std::size_t{y} * across_ + x) + half] = true;
          }
        }
      }
    }
  }
  return result;
}

}  // namespace candela::render

// The regions of adaptive sampling, and the estimates of their errors: docs/adaptive-sampling.md.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "host/base/divide_up.h"
#include "host/image/film.h"
#include "host/trace/render/extent.h"

namespace candela::render {

inline constexpr std::uint32_t kRegionSide = 16;  ///< of a region in pixels
inline constexpr std::uint32_t kCellSide = 4;     ///< of a cell, whose brightness is that to which errors are relative
inline constexpr std::uint32_t kBlockSide = 64;   ///< of a block in pixels; crops consist of whole blocks

/// A region's noise is smoothed over the regions of its block that are at most kSmoothingReach rows and columns away;
/// they have this weight, and the region itself has the weight 1.
inline constexpr double kNeighbourWeight = 0.25;
inline constexpr std::uint32_t kSmoothingReach = 2;

/// The half of its region to which a pixel of the full image belongs: the colour of its square on a chessboard.
constexpr std::uint32_t halfOf(std::uint32_t x, std::uint32_t y) { return (x + y) % 2; }

/// Statistics of the pixels of one half of a region, by which the noise of the other half is estimated.
struct HalfStatistics {
  std::uint32_t pixels = 0;
  /// Sum over pixels of the unbiased variance of the luminance of one sample, divided by the square of the mean
  /// luminance of the pixel's cell plus 0.01.
  double relativeVariance = 0;

  /// Returns the relative variance of one sample: the mean of the quotients above. Infinite for fewer than kMinPixels.
  double meanVariance() const;
  static constexpr std::uint32_t kMinPixels = 32;
};

/// The regions of a window of an image. Regions and blocks begin at multiples of their sides in the full image.
class AdaptiveRegions {
 public:
  /// The window consists of whole blocks, except at the edges of the image.
  explicit AdaptiveRegions(const Window& window);

  /// Index of the half-region of a pixel of the window: twice the index of the region plus the half.
  std::size_t halfRegionAt(std::uint32_t x, std::uint32_t y) const {
    return 2 * regionAt(x, y) + halfOf(window_.x + x, window_.y + y);
  }
  /// Index of the block of a pixel of the window.
  std::size_t blockAt(std::uint32_t x, std::uint32_t y) const {
    return std::size_t{y / kBlockSide} * divideUp(window_.width, kBlockSide) + x / kBlockSide;
  }
  std::size_t blockOfHalfRegion(std::size_t halfRegion) const {
    const std::size_t region = halfRegion / 2;
    return blockAt(static_cast<std::uint32_t>(region % across_) * kRegionSide,
                   static_cast<std::uint32_t>(region / across_) * kRegionSide);
  }
  std::size_t blockCount() const {
    return std::size_t{divideUp(window_.width, kBlockSide)} * divideUp(window_.height, kBlockSide);
  }
  std::size_t halfRegionCount() const { return 2 * std::size_t{across_} * down_; }
  /// Statistics of each half-region of a film of the window.
  std::vector<HalfStatistics> statisticsOf(const image::Film& film) const;
  /// Number of samples of a pixel of each half-region: the maximum over its pixels.
  std::vector<std::uint32_t> countsOf(const image::Film& film) const;
  /// Relative variance of one sample of each half-region, estimated from the other half of the region.
  std::vector<double> variancesOf(const image::Film& film) const;
  /// Relative standard deviation of one sample of each half-region: the weighted power mean, with the exponent 1/4, of
  /// the roots of the variances of the same half of the regions around it. Infinite variances do not count; the result
  /// is infinite where there are no others.
  std::vector<double> smoothedDeviations(const std::vector<double>& variances) const;

 private:
  std::size_t regionAt(std::uint32_t x, std::uint32_t y) const {
    return std::size_t{y / kRegionSide} * across_ + x / kRegionSide;
  }
  double smoothedDeviation(const std::vector<double>& variances, std::uint32_t x, std::uint32_t y,
                           std::size_t half) const;
  void addCell(const image::Film& film, std::uint32_t left, std::uint32_t top,
               std::vector<HalfStatistics>& statistics) const;

  Window window_;
  std::uint32_t across_, down_;
};

}  // namespace candela::render

// Adaptive sampling: which pixels of a film get more samples, decided only from the film.
#pragma once
#include <cstdint>
#include <optional>

#include "host/image/film.h"
#include "host/trace/render/adaptive_regions.h"
#include "host/trace/render/pixel_mask.h"

namespace candela::render {

/// Number of samples of every pixel before the first decision: the largest power of two that is at most
/// 0.2 / threshold^2, but at least 16 and at most 2^20. `threshold` > 0.
std::uint32_t pilotSamples(double threshold);

/// Number of samples that a half-region needs: the larger one of the number that brings its relative error to the
/// threshold, and one in proportion to its smoothed deviation, by which samples are best distributed.
/// `variance` and `deviation` are results of AdaptiveRegions. Infinite if one of them is.
double neededSamples(double variance, double deviation, double threshold);

/// The next work on a film. No film may be stored, or continued by another session, before the pixels have their
/// samples up to `indivisible`: only then do the numbers of samples show the decision that led to the step.
struct AdaptiveStep {
  PixelMask pixels;               ///< those that get samples
  std::uint32_t indivisible = 0;  ///< 0: the film shows the decision already
  std::uint32_t sampleEnd = 0;    ///< each of them gets its samples before this one
};

/// The rule of docs/adaptive-sampling.md for one window, one threshold and one maximum number of samples.
class AdaptivePlan {
 public:
  /// `threshold` > 0 is the relative error below which sampling stops; `maxSamples` > pilotSamples().
  AdaptivePlan(const Window& window, double threshold, std::uint32_t maxSamples)
      : regions_(window), threshold_(threshold), pilot_(pilotSamples(threshold)), maxSamples_(maxSamples) {}

  const AdaptiveRegions& regions() const { return regions_; }
  /// Returns the next step of a film after the previous steps, the last of which may have been interrupted;
  /// nothing if the film is finished.
  std::optional<AdaptiveStep> next(const image::Film& film) const;

 private:
  /// The state of the pixels of a block.
  struct Block {
    std::uint32_t max = 0;     ///< maximum number of samples of a pixel
    std::uint32_t active = 0;  ///< pixels with at least this number of samples get more,
    std::uint32_t end = 0;     ///< up to this number
    bool isPending = false;    ///< some of them lack samples
    bool isDecided = false;    ///< no pixel lacked samples, and the next decision gave more to some
  };

  std::uint32_t levelAbove(std::uint32_t samples) const;
  void setRange(Block& block) const;
  std::vector<Block> blocksOf(const image::Film& film) const;
  std::vector<bool> decide(const image::Film& film, const std::vector<Block>& blocks) const;
  void applyDecisions(const std::vector<bool>& continues, std::vector<Block>& blocks) const;

  AdaptiveRegions regions_;
  double threshold_;
  std::uint32_t pilot_;
  std::uint32_t maxSamples_;
};

/// Throws UsageError unless a window of an image consists of whole blocks, except at the edges of the image.
void requireAligned(const Window& window, const Extent& size);

}  // namespace candela::render

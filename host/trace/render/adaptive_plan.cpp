// Determines the state of the blocks of a film from the numbers of samples of their pixels.
#include "host/trace/render/adaptive_plan.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/base/errors.h"

namespace candela::render {
namespace {

bool isAligned(std::uint32_t first, std::uint32_t length, std::uint32_t whole) {
  const std::uint32_t end = first + length;
  return first % kBlockSide == 0 && (end % kBlockSide == 0 || end == whole);
}

// Calls use(x, y, number of samples) for each pixel, row by row from the top.
template <class Use>
void forEachPixel(const image::Film& film, Use&& use) {
  for (std::uint32_t y = 0; y < film.height(); ++y) {
    for (std::uint32_t x = 0; x < film.width(); ++x) use(x, y, film.at(x, y).sampleCount);
  }
}

}  // namespace

std::uint32_t pilotSamples(double threshold) {
  constexpr std::uint32_t kMin = 16, kMax = 1u << 20;
  constexpr double kNumerator = 0.2;
  std::uint32_t samples = kMin;
  while (samples < kMax && 2 * samples * threshold * threshold <= kNumerator) samples *= 2;
  return samples;
}

double neededSamples(double variance, double deviation, double threshold) {
  constexpr double kProportion = 2.5;  // the best one in trials, with the pilot above
  return std::max(variance, kProportion * deviation) / (threshold * threshold);
}

void requireAligned(const Window& window, const Extent& size) {
  if (isAligned(window.x, window.width, size.width) && isAligned(window.y, window.height, size.height)) return;
  throw UsageError(fmt::format(
      "the crop {}: with a noise threshold, each edge of the crop must be at a multiple of {} pixels or at an "
      "edge of the image",
      windowText(window), kBlockSide));
}

// Returns the number of samples at which the decision after the one at `samples` is made.
std::uint32_t AdaptivePlan::levelAbove(std::uint32_t samples) const {
  std::uint32_t level = pilot_;
  while (level <= samples) level *= 2;
  return std::min(level, maxSamples_);
}

// Pixels that the last decision stopped have at most as many samples as it was made with.
void AdaptivePlan::setRange(Block& block) const {
  if (block.max <= pilot_) {
    block.end = pilot_;
    return;
  }
  std::uint32_t level = pilot_;
  while (2 * level < block.max) level *= 2;
  block.active = level + 1;
  block.end = levelAbove(level);
}

std::vector<AdaptivePlan::Block> AdaptivePlan::blocksOf(const image::Film& film) const {
  std::vector<Block> blocks(regions_.blockCount());
  forEachPixel(film, [&](std::uint32_t x, std::uint32_t y, std::uint32_t samples) {
    Block& block = blocks[regions_.blockAt(x, y)];
    block.max = std::max(block.max, samples);
  });
  for (Block& block : blocks) setRange(block);
  forEachPixel(film, [&](std::uint32_t x, std::uint32_t y, std::uint32_t samples) {
    Block& block = blocks[regions_.blockAt(x, y)];
    if (samples >= block.active && samples < block.end) block.isPending = true;
  });
  return blocks;
}

// Returns which half-regions of the blocks that are not pending need more samples.
std::vector<bool> AdaptivePlan::decide(const image::Film& film, const std::vector<Block>& blocks) const {
  const std::vector<std::uint32_t> counts = regions_.countsOf(film);
  const std::vector<double> variances = regions_.variancesOf(film);
  const std::vector<double> deviations = regions_.smoothedDeviations(variances);
  std::vector<bool> continues(counts.size());
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const Block& block = blocks[regions_.blockOfHalfRegion(i)];
    const bool mayContinue = !block.isPending && block.end < maxSamples_ && counts[i] == block.end;
    continues[i] = mayContinue && counts[i] < neededSamples(variances[i], deviations[i], threshold_);
  }
  return continues;
}

void AdaptivePlan::applyDecisions(const std::vector<bool>& continues, std::vector<Block>& blocks) const {
  for (std::size_t i = 0; i < continues.size(); ++i) {
    Block& block = blocks[regions_.blockOfHalfRegion(i)];
    if (!continues[i] || block.isDecided) continue;
    block.isDecided = true;
    block.active = block.end;
    block.end = levelAbove(block.end);
  }
}

// In a merged film, blocks may be at different levels; they are brought to the same level first.
std::optional<AdaptiveStep> AdaptivePlan::next(const image::Film& film) const {
  std::vector<Block> blocks = blocksOf(film);
  const std::vector<bool> continues = decide(film, blocks);
  applyDecisions(continues, blocks);
  AdaptiveStep step{PixelMask(film.pixels().size()), 0, maxSamples_ + 1};
  for (const Block& block : blocks) {
    if (block.isPending || block.isDecided) step.sampleEnd = std::min(step.sampleEnd, block.end);
  }
  if (step.sampleEnd > maxSamples_) return std::nullopt;
  forEachPixel(film, [&](std::uint32_t x, std::uint32_t y, std::uint32_t samples) {
    const Block& block = blocks[regions_.blockAt(x, y)];
    if (block.end != step.sampleEnd || samples < block.active || samples >= block.end) return;
    if (block.isDecided && !continues[regions_.halfRegionAt(x, y)]) return;
    step.pixels[std::size_t{y} * film.width() + x] = true;
    if (block.isDecided) step.indivisible = block.active + 1;
  });
  return step;
}

}  // namespace candela::render

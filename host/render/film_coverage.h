// Which samples a film holds, for sessions that continue one.
#pragma once
#include <cstdint>
#include <span>

#include "host/image/film.h"
#include "host/render/session.h"

namespace candela::render {

/// The consecutive samples that each pixel of a session's film holds.
struct FilmCoverage {
  std::uint32_t first = 0;  ///< index of the first sample of each pixel
  /// The number of samples of every pixel where they have equally many; else kUneven, and the film's counts tell.
  std::uint32_t samples = 0;

  static constexpr std::uint32_t kUneven = 0xffffffffu;
  bool isEmpty() const { return samples == 0; }
};

/// The coverage of `film`, whose pixels start at sample `first`. Throws UsageError if the film has not `size`, or a
/// pixel holds samples beyond `sampleCount`.
FilmCoverage coverageOf(const image::Film& film, std::uint32_t first, const Extent& size, std::uint32_t sampleCount);

/// Throws UsageError unless `range` can be added to a film that is covered so; `minSamples` is the smallest number of
/// samples of a pixel.
void requireContiguous(const SampleRange& range, const FilmCoverage& coverage, std::uint32_t minSamples,
                       std::uint32_t sampleCount);

/// The smallest sampleCount of the pixels; 0 for none.
std::uint32_t minSampleCount(std::span<const image::FilmPixel> pixels);

}  // namespace candela::render

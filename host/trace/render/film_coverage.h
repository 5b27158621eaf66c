// The samples that a film contains, for sessions that continue it.
#pragma once
#include <cstdint>
#include <span>

#include "host/image/film.h"
#include "host/trace/render/session.h"
#include "host/trace/render/settings.h"

namespace candela::render {

/// The consecutive samples that each pixel of a session's film contains.
struct FilmCoverage {
  std::uint32_t first = 0;  ///< index of the first sample of each pixel
  /// The number of samples of every pixel if it is the same for all; else kUneven, and the film's counts are the
  /// numbers.
  std::uint32_t samples = 0;

  static constexpr std::uint32_t kUneven = 0xffffffffu;
  bool isEmpty() const { return samples == 0; }
  bool isUneven() const { return samples == kUneven; }
};

/// Returns the coverage of `film`, whose pixels start at sample `first`. Throws UsageError if the film's size is not
/// `size`, or if a pixel contains samples beyond `sampleCount`.
FilmCoverage coverageOf(const image::Film& film, std::uint32_t first, const Extent& size, std::uint32_t sampleCount);

/// Throws UsageError unless `range` can be added to a film with this coverage. `minSamples` is the minimum number of
/// samples of a pixel.
void requireContiguous(const SampleRange& range, const FilmCoverage& coverage, std::uint32_t minSamples,
                       std::uint32_t sampleCount);

/// Returns a film without samples, of the layers and the scale of a render.
image::Film emptyFilm(const ImageSettings& settings, const Extent& size);

/// Throws UsageError unless a film has the layers and the scale of a render that continues it.
void requireSameSums(const image::Film& film, const ImageSettings& settings);

/// Minimum sampleCount of the pixels; 0 if there are none.
std::uint32_t minSampleCount(std::span<const image::FilmPixel> pixels);

}  // namespace candela::render

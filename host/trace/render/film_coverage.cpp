// Checks ranges, and films that a session continues.
#include "host/trace/render/film_coverage.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/base/errors.h"

namespace candela::render {

FilmCoverage coverageOf(const image::Film& film, std::uint32_t first, const Extent& size, std::uint32_t sampleCount) {
  if (film.width() != size.width || film.height() != size.height) {
    throw UsageError(fmt::format("a film of {}x{} pixels cannot be continued by a render of {}", film.width(),
                                 film.height(), extentText(size)));
  }
  const auto [min, max] = std::ranges::minmax(film.pixels(), {}, &image::FilmPixel::sampleCount);
  if (std::uint64_t{first} + max.sampleCount > sampleCount) {
    throw UsageError(fmt::format("the film holds samples up to {}, but the render has {} per pixel",
                                 std::uint64_t{first} + max.sampleCount, sampleCount));
  }
  return {first, min.sampleCount == max.sampleCount ? min.sampleCount : FilmCoverage::kUneven};
}

void requireContiguous(const SampleRange& range, const FilmCoverage& coverage, std::uint32_t minSamples,
                       std::uint32_t sampleCount) {
  if (range.first > range.end || range.end > sampleCount) {
    throw UsageError(
        fmt::format("samples {} to {} are not among the {} of a pixel", range.first, range.end, sampleCount));
  }
  const bool startsWithin = range.first >= coverage.first && range.first - coverage.first <= minSamples;
  if (coverage.isEmpty() || startsWithin) return;
  throw UsageError(
      fmt::format("samples from {} on do not continue a film that starts at sample {} and holds {} per pixel",
                  range.first, coverage.first, minSamples));
}

image::Film emptyFilm(const ImageSettings& settings, const Extent& size) {
  return {size.width, size.height, settings.layers, settings.filmScale};
}

void requireSameSums(const image::Film& film, const ImageSettings& settings) {
  if (image::withSums(film.layers()) != image::withSums(settings.layers)) {
    throw UsageError("a film cannot be continued by a render with other layers");
  }
  if (film.scale() == settings.filmScale) return;
  throw UsageError(
      fmt::format("a film of scale {} cannot be continued by a render of scale {}", film.scale(), settings.filmScale));
}

std::uint32_t minSampleCount(std::span<const image::FilmPixel> pixels) {
  if (pixels.empty()) return 0;
  return std::ranges::min(pixels, {}, &image::FilmPixel::sampleCount).sampleCount;
}

}  // namespace candela::render

// Adds up the half-regions of a film.
#include "host/render/adaptive_summary.h"

#include <algorithm>
#include <cmath>

namespace candela::render {
namespace {

void addErrors(const std::vector<double>& errors, AdaptiveSummary& summary) {
  double squares = 0;
  std::size_t count = 0;
  for (const double error : errors) {
    if (!std::isfinite(error)) continue;
    squares += error * error;
    summary.maxError = std::max(summary.maxError, error);
    ++count;
  }
  summary.meanError = count == 0 ? 0 : std::sqrt(squares / static_cast<double>(count));
}

}  // namespace

AdaptiveSummary summarise(const AdaptivePlan& plan, const image::Film& film) {
  AdaptiveSummary summary;
  const auto [min, max] = std::ranges::minmax(film.pixels(), {}, &image::FilmPixel::sampleCount);
  summary.minSamples = min.sampleCount;
  summary.maxSamples = max.sampleCount;
  double samples = 0;
  for (const image::FilmPixel& pixel : film.pixels()) samples += pixel.sampleCount;
  summary.meanSamples = samples / static_cast<double>(film.pixels().size());
  const std::vector<std::uint32_t> counts = plan.regions().countsOf(film);
  for (const std::uint32_t count : counts) ++summary.halfRegions[count];
  addErrors(plan.regions().errorsOf(film, counts), summary);
  return summary;
}

}  // namespace candela::render

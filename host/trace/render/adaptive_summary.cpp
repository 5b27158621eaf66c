// Adds up the half-regions of a film.
#include "host/trace/render/adaptive_summary.h"

#include <algorithm>
#include <cmath>

namespace candela::render {
namespace {

void addErrors(const std::vector<double>& variances, const std::vector<std::uint32_t>& counts,
               AdaptiveSummary& summary) {
  double squares = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double square = variances[i] / counts[i];
    if (!std::isfinite(square)) continue;
    squares += square;
    summary.maxError = std::max(summary.maxError, std::sqrt(square));
    ++count;
  }
  summary.meanError = count == 0 ? 0 : std::sqrt(squares / static_cast<double>(count));
}

}  // namespace

SampleCounts sampleCountsOf(const image::Film& film) {
  const auto [min, max] = std::ranges::minmax(film.pixels(), {}, &image::FilmPixel::sampleCount);
  const auto samples = static_cast<double>(film.counts().samples);
  return {min.sampleCount, max.sampleCount, samples / static_cast<double>(film.pixels().size())};
}

AdaptiveSummary summarise(const AdaptivePlan& plan, const image::Film& film) {
  AdaptiveSummary summary{sampleCountsOf(film), {}};
  const std::vector<std::uint32_t> counts = plan.regions().countsOf(film);
  for (const std::uint32_t count : counts) ++summary.halfRegions[count];
  addErrors(plan.regions().variancesOf(film), counts, summary);
  return summary;
}

}  // namespace candela::render

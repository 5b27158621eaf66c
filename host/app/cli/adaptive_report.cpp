// Describes adaptively sampled films.
#include "host/app/cli/adaptive_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "host/base/errors.h"
#include "host/trace/render/adaptive_summary.h"

namespace candela::cli {

using nlohmann::ordered_json;

std::string adaptiveText(const image::Film& film) {
  const render::SampleCounts counts = render::sampleCountsOf(film);
  return fmt::format("{} to {} samples per pixel, {:.1f} on average", counts.minSamples, counts.maxSamples,
                     counts.meanSamples);
}

ordered_json adaptiveJson(const render::AdaptivePlan& plan, const image::Film& film, std::uint32_t maxSamples) {
  const render::AdaptiveSummary summary = summarise(plan, film);
  ordered_json halfRegions = ordered_json::object();
  for (const auto& [samples, count] : summary.halfRegions) halfRegions[fmt::to_string(samples)] = count;
  const double saved = 1 - summary.meanSamples / maxSamples;
  return {{"minSamples", summary.minSamples}, {"meanSamples", summary.meanSamples}, {"maxSamples", summary.maxSamples},
          {"savedFraction", saved},           {"halfRegions", halfRegions},         {"meanError", summary.meanError},
          {"maxError", summary.maxError}};
}

std::string adaptiveBiasText(const std::string& threshold) {
  return fmt::format(
      "--noise-threshold {}: the number of samples of a pixel depends on their values (docs/adaptive-sampling.md)",
      threshold);
}

}  // namespace candela::cli

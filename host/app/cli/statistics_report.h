// The statistics of a render, as JSON and as text.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "host/app/cli/render_job.h"
#include "host/job/film/work_report.h"
#include "host/trace/render/bad_sample_tally.h"

namespace candela::cli {

struct RenderReport {
  const RenderJob& job;
  const render::RenderResult& result;
  double writeSeconds = 0;
  double totalSeconds = 0;
  render::BadSampleTally badSamples{};     ///< bad samples of the result's film
  std::optional<film::WorkReport> work{};  ///< of all runs that made the film, if it has a file
};

/// Logs bad samples, with the commands that replay them, and rays that found volumes in disorder.
void reportFlaws(const RenderReport& report, const Log& log);
/// Returns all figures, with keys in lowerCamel. Rates are per second of the phase `trace`.
nlohmann::ordered_json toJson(const RenderReport& report);
/// Returns all figures as a table.
std::string toText(const RenderReport& report);

}  // namespace candela::cli

// Tells which samples were bad, how to see them again, and what --strict makes of them.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "host/cli/render_job.h"
#include "host/core/errors.h"
#include "host/render/bad_sample_tally.h"

namespace candela::cli {

/// The command that shows the pixel's first bad sample again: its path on both tracers, or, where the integrator
/// follows no paths, the picture as far as that sample.
std::string replayCommand(const render::BadPixel& pixel, const RenderJob& job);

/// One line in total and one for each of the first few pixels, with its replay; empty if no sample was bad.
std::vector<std::string> badSampleLines(const render::BadSampleTally& tally, const RenderJob& job);

/// The first few pixels, each with x, y, badSamples, firstSample and replay.
nlohmann::ordered_json firstPixelsJson(const render::BadSampleTally& tally, const RenderJob& job);

/// Of two tracers: for each the numbers of bad samples and of pixels that have some, and the first of these.
nlohmann::ordered_json badSamplesJson(const render::BadSampleTallies& tallies, const RenderJob& job);
/// Puts the lines of both into the log.
void reportBadSamples(const render::BadSampleTallies& tallies, const RenderJob& job, const Log& log);

/// `code`; but where a run is otherwise in order and --strict forbids the bad samples that it met, says so and gives
/// ExitCode::differ.
ExitCode strictly(ExitCode code, std::uint64_t badSamples, const Arguments& arguments, const Log& log);

}  // namespace candela::cli

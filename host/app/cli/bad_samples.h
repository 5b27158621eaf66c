// Reports bad samples, the commands that replay them, and the effect of --strict.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "host/app/cli/render_job.h"
#include "host/base/errors.h"
#include "host/trace/render/bad_sample_tally.h"

namespace candela::cli {

/// Returns the command that replays the first bad sample of the pixel: its path on both tracers or, if the integrator
/// has no paths, the image up to this sample.
std::string replayCommand(const render::BadPixel& pixel, const RenderJob& job);

/// Returns one line for the total and one for each of the first few pixels, with its replay; nothing if there are no
/// bad samples.
std::vector<std::string> badSampleLines(const render::BadSampleTally& tally, const RenderJob& job);

/// Returns the member `badSamples` of JSON documents: the numbers of bad samples and of pixels with bad samples, and
/// the first few of these, with the commands that replay them if the job is known.
nlohmann::ordered_json badSamplesJson(const render::BadSampleTally& tally);
nlohmann::ordered_json badSamplesJson(const render::BadSampleTally& tally, const RenderJob& job);
/// Returns an object with this member for each of two tracers.
nlohmann::ordered_json badSamplesJson(const render::BadSampleTallies& tallies, const RenderJob& job);
/// Writes the lines of both tracers to the log.
void reportBadSamples(const render::BadSampleTallies& tallies, const RenderJob& job, const Log& log);

/// Returns `code`, except that --strict turns success, or a verdict that is not decided, into ExitCode::differ, with a
/// message, if there are bad samples.
ExitCode strictly(ExitCode code, std::uint64_t badSamples, const StrictArguments& arguments, const Log& log);

}  // namespace candela::cli

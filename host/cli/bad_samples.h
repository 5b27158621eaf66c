// Tells which samples were bad, and how to see them again.
#pragma once
#include <string>
#include <vector>

#include "host/cli/render_job.h"
#include "host/image/film.h"

namespace candela::cli {

/// One line in total and one for each of the first few pixels that have bad samples, with the command that replays
/// the pixel's first; empty if there are none.
std::vector<std::string> badSampleReport(const Film& film, const RenderJob& job);

}  // namespace candela::cli

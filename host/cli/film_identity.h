// Describes a render in its film file.
#pragma once
#include <cstdint>

#include "host/cli/render_job.h"
#include "host/film/film_file.h"

namespace candela::cli {

/// Returns the header of the film of a job, without samples. `statistics` are those of the prepared session.
film::FilmHeader filmHeaderOf(const RenderJob& job, const render::RenderStatistics& statistics);

/// Sets the parts of the header that depend on the samples: the coverage of a film whose pixels hold consecutive
/// samples from `first` on, and the names of its mattes.
void setContent(film::FilmHeader& header, const image::Film& film, const scene::Scene& scene, std::uint32_t first);

/// Returns the samples of each pixel that a job renders. Throws UsageError if --samples exceeds --spp.
render::SampleRange samplesOf(const RenderJob& job);

}  // namespace candela::cli

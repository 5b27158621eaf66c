// Refuses to resume a film file whose samples do not fit those of a render. All functions throw FileError.
#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "host/cli/render_job.h"
#include "host/film/film_file.h"

namespace candela::cli {

/// Sets the number of samples per pixel in a film's header to that of the job. A film may be resumed with another --spp
/// if its samples do not depend on it.
void adoptSampleCount(const RenderJob& job, const film::FilmReader& reader, film::FilmHeader& film);

/// Returns the next step after a refusal. Films of other pixels cannot be resumed at all.
std::string remedyFor(const film::FilmHeader& film, const film::FilmHeader& render);

void requireSameWindow(const film::FilmReader& film, const film::FilmHeader& header);
/// Sums that samples did not add cannot be computed later, whatever the user accepts.
void requireSameLayers(const RenderJob& job, const film::FilmReader& film, const film::FilmHeader& header);
/// Sums of different units cannot be added, whatever the user accepts.
void requireSameScale(const film::FilmReader& film, const film::FilmHeader& header);

/// Returns the first sample of a film, which must be one that samples can be appended to; nothing for a film without
/// samples. `isPart`: the range is that of --samples, rather than all samples.
std::optional<std::uint32_t> requireContinuable(const film::FilmReader& reader, const render::SampleRange& range,
                                                bool isPart);

/// Refuses a film if one of its pixels has more samples than the job renders. The header of a film with a noise
/// threshold does not state how many its pixels have; of all other films, requireContinuable() knows.
void requireNoMoreSamples(const RenderJob& job, const film::FilmReader& reader, const image::Film& film);

}  // namespace candela::cli

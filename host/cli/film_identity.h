// Describes a render in its film file, and decides whether a render can resume a film file.
#pragma once
#include <filesystem>
#include <optional>

#include "host/cli/render_job.h"
#include "host/film/film_file.h"

namespace candela::cli {

/// Returns the header of the film of a job, without samples. `statistics` are those of the prepared session.
film::FilmHeader filmHeaderOf(const RenderJob& job, const render::RenderStatistics& statistics);

/// Sets the parts of the header that depend on the samples: the coverage of a film whose pixels hold consecutive
/// samples from `first` on, and the names of its mattes.
void setContent(film::FilmHeader& header, const image::Film& film, const scene::Scene& scene, std::uint32_t first);

/// Adapts the header of a film to another session that continues it after the device failed: `now` is that of the
/// session. Throws DeviceLostError if the session's device or driver differs, unless `mayDiffer`; then the film
/// is marked as mixed.
void continueWith(film::FilmHeader& film, const film::FilmHeader& now, bool mayDiffer);

/// Returns the samples of each pixel that a job renders. Throws UsageError if --samples exceeds --spp.
render::SampleRange samplesOf(const RenderJob& job);

/// Adapts the header of a job to that of the film that it resumes: a film that differs is refused with FileError, which
/// names the first difference, or with --resume-anyway marks the header as mixed. Returns the index of the film's first
/// sample, or nothing for a film without samples.
std::optional<std::uint32_t> adoptFilm(const RenderJob& job, const film::FilmReader& film, film::FilmHeader& header,
                                       const Log& log);

/// Throws FileError if a pixel of the film that a job resumes has more samples than the job renders. The header of a
/// film with a noise threshold does not state how many its pixels have; of all other films, adoptFilm() knows.
void requireNoMoreSamples(const RenderJob& job, const film::FilmReader& reader, const image::Film& film);

}  // namespace candela::cli

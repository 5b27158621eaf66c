// Decides whether a render can resume a film file, and marks films whose parts differ.
#pragma once
#include <cstdint>
#include <optional>

#include "host/cli/render_job.h"
#include "host/film/film_file.h"

namespace candela::cli {

/// Adapts the header of a film to another session that continues it after the device failed: `now` is that of the
/// session. Throws DeviceLostError if the session's device or driver differs, unless `mayDiffer`; then the film
/// is marked as mixed.
void continueWith(film::FilmHeader& film, const film::FilmHeader& now, bool mayDiffer);

/// Adapts the header of a job to that of the film that it resumes: a film that differs is refused with FileError, which
/// names the first difference, or with --resume-anyway marks the header as mixed. Returns the index of the film's first
/// sample, or nothing for a film without samples.
std::optional<std::uint32_t> adoptFilm(const RenderJob& job, const film::FilmReader& film, film::FilmHeader& header,
                                       const Log& log);

}  // namespace candela::cli

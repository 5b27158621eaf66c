// Decides whether a render can resume a film file, and marks films whose parts differ.
#pragma once
#include <cstdint>
#include <optional>

#include "host/base/log.h"
#include "host/job/film/film_file.h"
#include "host/job/job.h"

namespace candela::job {

/// Adapts the header of a film to another session that continues it after the device failed: `now` is that of the
/// session. Throws DeviceLostError if the session's device or driver differs, unless `mayDiffer`; then the film
/// is marked as mixed.
void continueWith(film::FilmHeader& film, const film::FilmHeader& now, bool mayDiffer);

/// Adapts the header of a job to that of the film that it resumes. A film that differs is refused with FileError, which
/// names the first difference and the settings that remove it, or with FilmPolicy::resumeAnyway marks the header as
/// mixed. Returns the index of the film's first sample, or nothing for a film without samples.
std::optional<std::uint32_t> adoptFilm(const Job& job, const film::FilmReader& film, film::FilmHeader& header,
                                       const Log& log);

/// Throws FileError if one of the film's pixels has more samples than the job renders. The header of a film with a
/// noise threshold does not state how many its pixels have; of all other films, adoptFilm() knows.
void requireNoMoreSamples(const Job& job, const film::FilmReader& reader, const image::Film& film);

}  // namespace candela::job

// Films and jobs: exact sums of samples in memory and in film files, and renders that run to one.
//
//   candela::Job job{scene, {}, candela::resolve(request, *scene)};
//   job.film.checkpoint = "room.film.exr";  // written every minute and at the end
//   const auto done = candela::runJob(job, [] { return candela::makeGpuRenderer(""); }, {}, log);
//
// docs/film-file.md specifies the files, which other programs open as OpenEXR pictures.
#pragma once
#include "host/job/film/film_file.h"
#include "host/job/film/merge.h"
#include "host/job/run_job.h"

namespace candela {

/// Integer sums and counts per pixel: the same bytes for any order and division of the samples.
using image::Film;

/// A scene, resolved settings, and a film policy.
using job::Job;
/// Part of the samples, film files to continue and to write, time limit (seconds), noise threshold, and what happens if
/// the device fails.
using job::Fallback;
using job::FilmPolicy;
/// A function that opens the device of a job; an empty one stands for the reference.
using job::OpenDevice;
/// A flag that stops a job, and functions that get its progress and its film.
using job::JobControl;
/// The film, its statistics, and whether time, a device or a file failed.
using job::JobResult;
/// Runs a job on the tracer that the function opens, or on the reference without one. Throws UsageError for settings
/// that contradict each other, FileError for a film that cannot be continued, OutOfMemoryError before anything is
/// rendered that cannot fit, and Error if a device failed before there was a sample.
using job::runJob;

/// Reads and writes film files. All throw FileError, which names the file.
using film::FilmHeader;
using film::FilmReader;
using film::readFilm;
using film::writeFilm;
/// Adds the films of parts of a render. Throws FileError if they are not parts of one.
using film::mergeFilms;

}  // namespace candela

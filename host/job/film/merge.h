// Adds films of parts of a render.
#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "host/job/film/film_file.h"
#include "host/job/film/work_report.h"

namespace candela::film {

struct MergeOptions {
  bool mixedDevices = false;  ///< accept films of different devices
  bool partial = false;       ///< accept that samples of the image are missing
};

struct MergedFilm {
  FilmHeader header;
  image::Film film;
  WorkReport work;
  std::vector<SampleBox> missing;  ///< samples that no film has; those of FilmHeader::begun are not among them
};

/// The sum of films, which is the same for any order and any division into parts. It has the bounding box of their
/// windows. Takes the memory of that film and of a block of one of the others. Throws FileError if a file is not a
/// film, or if the films differ in scene, settings or (but for options.mixedDevices) tracer, have samples in common or,
/// but for options.partial, leave samples out; it names the files.
MergedFilm mergeFilms(std::span<const std::filesystem::path> files, const MergeOptions& options);

}  // namespace candela::film

// Adapts the headers of films that are resumed.
#include "host/cli/film_resumption.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/cli/film_identity.h"
#include "host/cli/resume_checks.h"
#include "host/core/errors.h"

namespace candela::cli {
namespace {

template <class T>
void insertSorted(std::vector<T>& items, const T& item) {
  const auto found = std::ranges::lower_bound(items, item);
  if (found == items.end() || *found != item) items.insert(found, item);
}

}  // namespace

void continueWith(film::FilmHeader& film, const film::FilmHeader& now, bool mayDiffer) {
  const film::Tracer& tracer = now.tracers.front();
  const bool isKnown = std::ranges::find(film.tracers, tracer) != film.tracers.end();
  if (!isKnown && !mayDiffer) {
    throw DeviceLostError(fmt::format(
        "after the failure, {}", tracerDifferences(film.tracers.front(), tracer, "the film", "the device").front()));
  }
  insertSorted(film.tracers, tracer);
  for (const std::string& line : estimateDifferences(film, now, "an earlier part", "a later part")) {
    insertSorted(film.mixed, line);
  }
}

std::optional<std::uint32_t> adoptFilm(const RenderJob& job, const film::FilmReader& reader, film::FilmHeader& header,
                                       const Log& log) {
  film::FilmHeader film = reader.header();
  adoptSampleCount(job, reader, film);
  requireSameLayers(job, reader, header);
  requireSameScale(reader, header);
  std::vector<std::string> differences = estimateDifferences(film, header, "the film", "this render");
  for (const film::Tracer& tracer : film.tracers) {
    const auto more = tracerDifferences(tracer, header.tracers.front(), "the film", "this render");
    differences.insert(differences.end(), more.begin(), more.end());
  }
  if (!differences.empty() && !job.arguments.resumeAnyway) {
    throw FileError(fmt::format(
        "{}: {}{}; {}", reader.file().string(), differences.front(),
        film.sceneHash == header.sceneHash ? "" : ": a file of the scene, --env, --camera or --time differs",
        remedyFor(reader.header(), header)));
  }
  for (const std::string& difference : differences) log.warning("--resume-anyway: " + difference);
  requireSameWindow(reader, header);
  for (const std::string& line : estimateDifferences(film, header, "an earlier part", "a later part")) {
    insertSorted(header.mixed, line);
  }
  for (const std::string& line : film.mixed) insertSorted(header.mixed, line);
  for (const film::Tracer& tracer : film.tracers) insertSorted(header.tracers, tracer);
  return requireContinuable(reader, samplesOf(job), job.arguments.samples.has_value());
}

}  // namespace candela::cli

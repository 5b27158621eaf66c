// Renders the film of `candela render`, from the beginning or from a film file, and writes checkpoints.
#pragma once
#include <atomic>
#include <functional>
#include <optional>

#include "host/cli/render_job.h"
#include "host/core/errors.h"
#include "host/film/film_header.h"
#include "host/film/work_report.h"

namespace candela::cli {

/// The means by which a caller watches and stops a render.
struct TraceControl {
  const std::atomic<bool>& stop;                        ///< true: the render ends with the samples so far
  std::atomic<bool>* writeRequested = nullptr;          ///< true: the film is written, and the flag reset; null: never
  std::function<void(double, std::uint64_t)> report{};  ///< as FilmProgress::Report; empty: a line on stderr
  std::function<void(const image::Film&)> show{};  ///< gets the film from time to time, and at the end; may be empty
};

struct DeviceFailure {
  ExitCode code = ExitCode::deviceLost;
  std::string message;
};

struct TracedFilm {
  render::RenderResult result;
  film::FilmHeader header;  ///< of the film, with its coverage
  /// The work of all runs that made the film; nothing if it neither came from a film file nor went to one.
  std::optional<film::WorkReport> work;
  bool isFilmLost = false;  ///< the film could not be written in the end
  /// The device failed for good: the result has the samples before that.
  std::optional<DeviceFailure> failure{};
};

/// `start` is the time of monotonicSeconds() from which --time-limit counts. Throws as render::Renderer::prepare() and
/// Session::advance() do, and FileError for films that cannot be resumed or written.
TracedFilm traceFilm(const RenderJob& job, double start, const TraceControl& control, const Log& log);

}  // namespace candela::cli

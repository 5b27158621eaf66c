// Runs a job to a film: from the beginning or from a film file, with checkpoints, and on past failures of the device.
#pragma once
#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "host/base/errors.h"
#include "host/base/log.h"
#include "host/base/progress.h"
#include "host/job/film/film_header.h"
#include "host/job/film/work_report.h"
#include "host/job/job.h"
#include "host/trace/reference/reference_renderer.h"
#include "host/trace/render/renderer.h"

namespace candela::job {

/// Opens a tracer of a job. It is called again after each failure, and throws as the tracers do.
using OpenDevice = std::function<std::unique_ptr<render::Renderer>()>;

/// The means by which a caller watches and stops a job.
struct JobControl {
  const std::atomic<bool>* stop = nullptr;      ///< true: the job ends with the samples so far; null: never
  std::atomic<bool>* writeRequested = nullptr;  ///< true: the film is written, and the flag reset; null: never
  ProgressStyle line = ProgressStyle::none;     ///< of a line on stderr
  /// Gets the fraction that is done, including the samples of earlier runs, and the number of samples that this process
  /// has traced. It may be empty.
  std::function<void(double fraction, std::uint64_t samples)> report{};
  std::function<void(const image::Film&)> show{};  ///< gets the film from time to time, and at the end; may be empty
  double start = monotonicSeconds();  ///< time of monotonicSeconds() from which FilmPolicy::timeLimit counts
};

/// A device that failed for good.
struct DeviceFailure {
  ExitCode code = ExitCode::deviceLost;
  std::string message;
};

struct JobResult {
  render::RenderResult result;
  film::FilmHeader header;  ///< of the film, with its coverage
  /// The work of all runs that made the film; nothing if it neither came from a film file nor went to one.
  std::optional<film::WorkReport> work;
  bool isFilmLost = false;  ///< the film could not be written in the end
  bool isTimeUp = false;    ///< the job ended because of FilmPolicy::timeLimit
  /// The device failed for good: the result has the samples before that.
  std::optional<DeviceFailure> failure{};
};

/// Runs a job on the device that `open` opens, or on the reference, which `openReference` opens, if it is empty. Throws
/// as requirePossible(), render::Renderer::prepare() and Session::advance() do; FileError for films that cannot be
/// resumed; and Error, with the code of the failure, if the device failed for good before there was a sample. A film
/// that cannot be written is a problem in the log.
JobResult runJob(const Job& job, const OpenDevice& open, const JobControl& control, const Log& log,
                 const OpenDevice& openReference = reference::makeReferenceRenderer);

}  // namespace candela::job

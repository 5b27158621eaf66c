// The loop around a session: it advances until the film must be written or the render must end. A device that fails is
// opened again.
#include "host/cli/trace_film.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <limits>
#include <new>

#include "host/cli/film_identity.h"
#include "host/cli/film_progress.h"
#include "host/cli/film_resumption.h"
#include "host/cli/film_trace.h"
#include "host/cli/option_table.h"
#include "host/cli/resume_checks.h"
#include "host/core/interrupt.h"

namespace candela::cli {
namespace {

// Checks the scene and the options before the session is prepared, which takes time.
std::optional<film::FilmReader> openFilm(const RenderJob& job) {
  if (job.arguments.resume.empty()) return std::nullopt;
  return film::FilmReader(job.arguments.resume);
}

void noteStop(const RenderJob& job, const RenderWatch& watch, const Log& log) {
  if (watch.isTimeUp()) log.note("--time-limit: the time limit is reached");
  if (isProcessorTimeUp()) log.note("the limit of processor time (ulimit -t) is reached");
  if (job.arguments.checkpoint.empty()) return;
  const std::string file = shellQuoted(job.arguments.checkpoint.string());
  log.note(fmt::format("run the same command with --resume {} to continue", file));
}

double deadlineOf(const RenderJob& job, double start) {
  return start + job.arguments.timeLimit.value_or(std::numeric_limits<double>::infinity());
}

}  // namespace

FilmTrace::FilmTrace(const RenderJob& job, double start, const TraceControl& control, const Log& log)
    : job_(job),
      log_(log),
      control_(control),
      range_(samplesOf(job)),
      settings_(job.settings),
      usesReference_(job.arguments.usesReference()),
      reader_(openFilm(job)),
      watch_(deadlineOf(job, start), control.stop, control.writeRequested),
      failures_(job, log) {}

Checkpoints FilmTrace::checkpointsAt(const std::filesystem::path& file) const {
  film::WorkReport before = inheritance_.work;
  before.add(lost_);
  return {job_.scene, file, job_.arguments.checkpointEvery, header_, inheritance_.firstSample, before, log_};
}

void FilmTrace::load(const image::Film& film) {
  session_->load(film, inheritance_.firstSample);
  samplesBefore_ = film.counts().samples;
}

// The first session resumes the film file, if there is one.
void FilmTrace::startOrResume() {
  header_ = filmHeaderOf(job_, session_->statistics());
  inheritance_ = {range_.first, {}};
  if (reader_) {
    inheritance_.work = film::readWork(reader_->file(), reader_->check());
    if (adoptFilm(job_, *reader_, header_, log_)) {
      const image::Film film = film::readFilm(*reader_);
      requireNoMoreSamples(job_, *reader_, film);
      load(film);
    }
  }
  if (hasFile()) checkpoints_.emplace(checkpointsAt(job_.arguments.checkpoint));
}

void FilmTrace::begin() {
  isReady_ = false;
  settings_.execution.maxBandBytes = failures_.maxBandBytes();
  settings_.execution.dispatchSeconds = failures_.dispatchSeconds();
  Arguments arguments = job_.arguments;
  if (usesReference_) arguments.device = render::kReferenceDevice;
  renderer_ = makeRenderer(arguments, log_);
  session_ = renderer_->prepare(job_.scene, settings_);
  loop_.emplace(*session_, watch_, [this](bool mustWrite) { pause(mustWrite); });
  if (salvaged_) {
    continueSalvagedFilm();
  } else {
    startOrResume();
  }
  isReady_ = true;
}

// The film reaches the host when it is written; without a file, it is read from time to time, so that less is lost if
// the device fails. Reading takes at most 1 % of the time.
void FilmTrace::scheduleWrite(double start) {
  constexpr double kMinSeconds = 10, kMinTimesItsCost = 100;
  const double now = monotonicSeconds();
  if (hasFile()) {
    watch_.writeAt(checkpoints_->nextWrite());
  } else if (!usesReference_) {
    watch_.writeAt(now + std::max(kMinSeconds, kMinTimesItsCost * (now - start)));
  }
}

// Work that was truncated must not reach a film file.
void FilmTrace::pause(bool mustWrite) {
  const double start = monotonicSeconds();
  const render::RenderStatistics statistics = session_->statistics();
  render::requireComplete(statistics);
  if (hasFile() && mustWrite) checkpoints_->write(loop_->storableFilm(), statistics, start);
  scheduleWrite(start);
  show();
}

// At most five times per second, which takes at most a tenth of the time.
void FilmTrace::show() {
  constexpr double kMinSeconds = 0.2, kMinTimesItsCost = 10;
  if (!control_.show) return;
  const double start = monotonicSeconds();
  control_.show(session_->film());
  const double end = monotonicSeconds();
  watch_.showAt(end + std::max(kMinSeconds, kMinTimesItsCost * (end - start)));
}

void FilmTrace::advance() {
  Progress line(std::cerr, control_.report ? ProgressStyle::none : progressStyle(log_.verbosity()));
  const auto showLine = [&](double fraction, std::uint64_t samples) { line.update(fraction, samples); };
  FilmProgress filmProgress(job_, range_, samplesBefore_, control_.report ? control_.report : showLine);
  scheduleWrite(monotonicSeconds());
  show();
  const auto plan = planOf(header_);
  isInterrupted_ = plan ? !loop_->traceAdaptively(*plan, range_.end, filmProgress)
                        : !loop_->trace(range_, filmProgress);
}

film::FilmHeader FilmTrace::headerOf(const image::Film& film) const {
  film::FilmHeader header = header_;
  setContent(header, film, job_.scene, inheritance_.firstSample);
  return header;
}

TracedFilm FilmTrace::end() {
  TracedFilm traced;
  traced.result.interrupted = isInterrupted_;
  traced.result.film = loop_->storableFilm();
  traced.result.statistics = session_->statistics();
  render::requireComplete(traced.result.statistics);
  traced.header = headerOf(traced.result.film);
  if (control_.show) control_.show(traced.result.film);
  if (checkpoints_) {
    traced.isFilmLost = !checkpoints_->write(traced.result.film, traced.result.statistics, monotonicSeconds());
    traced.work = checkpoints_->work();
  } else if (reader_ || failures_.count() > 0) {
    traced.work = inheritance_.work;
    traced.work->add(lost_);
    traced.work->add(film::workOf(traced.result.statistics));
  }
  if (isInterrupted_) noteStop(job_, watch_, log_);
  return traced;
}

TracedFilm FilmTrace::attempt() {
  begin();
  advance();
  return end();
}

TracedFilm FilmTrace::run() {
  std::optional<TracedFilm> ended;
  while (!ended) {
    try {
      return attempt();
    } catch (const std::bad_alloc&) {
      if (usesReference_) throw;
      ended = handle(OutOfMemoryError("out of host memory"));
    } catch (const Error& error) {
      if (usesReference_ || !failures_.isOne(error)) throw;
      ended = handle(error);
    }
  }
  return std::move(*ended);
}

TracedFilm traceFilm(const RenderJob& job, double start, const TraceControl& control, const Log& log) {
  return FilmTrace(job, start, control, log).run();
}

}  // namespace candela::cli

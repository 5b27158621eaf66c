// The loop around a session: it advances until the film must be written or the render must end. A device that fails is
// opened again.
#include "host/cli/trace_film.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <limits>
#include <new>

#include "host/cli/checkpoints.h"
#include "host/cli/device_failures.h"
#include "host/cli/film_identity.h"
#include "host/cli/film_progress.h"
#include "host/cli/option_table.h"
#include "host/cli/render_watch.h"
#include "host/cli/rescue_file.h"
#include "host/cli/sample_loop.h"
#include "host/core/interrupt.h"

namespace candela::cli {
namespace {

// The state from which a render continues: the first sample that it traces, and the work of earlier runs.
struct Inheritance {
  std::uint32_t firstSample = 0;
  film::WorkReport work;
};

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

/// One render on one device after the other, as long as devices fail.
class FilmTrace {
 public:
  FilmTrace(const RenderJob& job, double start, const TraceControl& control, const Log& log)
      : job_(job),
        log_(log),
        control_(control),
        range_(samplesOf(job)),
        settings_(job.settings()),
        usesReference_(job.arguments.usesReference()),
        reader_(openFilm(job)),
        watch_(deadlineOf(job, start), control.stop, control.writeRequested),
        failures_(job, log) {}

  TracedFilm run();

 private:
  bool hasFile() const { return !job_.arguments.checkpoint.empty(); }
  TracedFilm attempt();
  void begin();
  void load(const image::Film& film);
  void startOrResume();
  void continueSalvagedFilm();
  void advance();
  void pause(bool mustWrite);
  void show();
  void scheduleWrite(double start);
  film::FilmHeader headerOf(const image::Film& film) const;
  TracedFilm end();
  std::optional<TracedFilm> handle(const Error& error);
  void salvage();
  bool fallBack(const Error& error);
  TracedFilm giveUp(const Error& error);
  bool rescue(std::filesystem::path& file);
  Checkpoints checkpointsAt(const std::filesystem::path& file) const;

  const RenderJob& job_;
  const Log& log_;
  const TraceControl& control_;
  render::SampleRange range_;
  render::RenderSettings settings_;
  bool usesReference_;
  std::optional<film::FilmReader> reader_;
  RenderWatch watch_;
  DeviceFailures failures_;

  std::unique_ptr<render::Renderer> renderer_;
  std::unique_ptr<render::Session> session_;
  bool isReady_ = false;  ///< the session has the film so far
  film::FilmHeader header_;
  Inheritance inheritance_;
  std::optional<Checkpoints> checkpoints_;   ///< with --checkpoint, from the first session on
  std::optional<render::Salvage> salvaged_;  ///< of the last session that failed
  film::WorkReport lost_;                    ///< of all sessions that failed
  std::uint64_t samplesBefore_ = 0;          ///< in the film that the session resumed
  bool isInterrupted_ = false;
  std::optional<SampleLoop> loop_;  ///< around `session_`
};

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

// Later sessions continue the film of the previous one.
void FilmTrace::continueSalvagedFilm() {
  const film::FilmHeader now = filmHeaderOf(job_, session_->statistics());
  if (salvaged_->film.counts().samples == 0) {
    header_.tracers = now.tracers;
  } else {
    continueWith(header_, now, usesReference_);
    load(salvaged_->film);
  }
  film::WorkReport work = film::workOf(salvaged_->statistics);
  work.runs = 0;
  lost_.add(work);
  if (checkpoints_) checkpoints_->continueAfterFailure(header_, work);
  salvaged_.reset();
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

// Destroys the session after taking its film.
void FilmTrace::salvage() {
  if (isReady_) salvaged_ = session_->salvage();
  auto decided = loop_ ? loop_->takeDecided() : std::nullopt;
  if (salvaged_ && decided) salvaged_->film = std::move(*decided);
  loop_.reset();
  session_.reset();
  renderer_.reset();
  isReady_ = false;
  if (salvaged_) render::requireComplete(salvaged_->statistics);
  if (!salvaged_ && reader_) reader_.emplace(job_.arguments.resume);
}

bool FilmTrace::fallBack(const Error& error) {
  if (job_.arguments.fallback != Fallback::reference || usesReference_) return false;
  log_.warning(fmt::format("{}; --fallback cpu: the reference tracer finishes the render", error.what()));
  usesReference_ = true;
  return true;
}

// Writes the film to --checkpoint, or else to a file beside the output. Returns whether `file` has it.
bool FilmTrace::rescue(std::filesystem::path& file) {
  file = hasFile() ? job_.arguments.checkpoint : rescueFile(job_.arguments);
  if (file.empty()) return false;
  if (!checkpoints_) checkpoints_.emplace(checkpointsAt(file));
  return checkpoints_->write(salvaged_->film, salvaged_->statistics, monotonicSeconds());
}

TracedFilm FilmTrace::giveUp(const Error& error) {
  std::filesystem::path file;
  const bool hasSamples = salvaged_ && salvaged_->film.counts().samples > 0;
  if (hasSamples && !rescue(file)) file.clear();
  DeviceFailure failure{DeviceFailures::codeOf(error), failures_.explain(error, file.string())};
  if (!hasSamples) throw Error(failure.code, failure.message);
  TracedFilm traced;
  traced.result.interrupted = true;
  traced.result.film = std::move(salvaged_->film);
  traced.result.statistics = std::move(salvaged_->statistics);
  traced.header = headerOf(traced.result.film);
  if (checkpoints_) traced.work = checkpoints_->work();
  traced.isFilmLost = file.empty();
  traced.failure = std::move(failure);
  return traced;
}

// Returns nothing if the render continues.
std::optional<TracedFilm> FilmTrace::handle(const Error& error) {
  salvage();
  if (failures_.mayTryAgain(error) || fallBack(error)) return std::nullopt;
  return giveUp(error);
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

}  // namespace

TracedFilm traceFilm(const RenderJob& job, double start, const TraceControl& control, const Log& log) {
  return FilmTrace(job, start, control, log).run();
}

}  // namespace candela::cli

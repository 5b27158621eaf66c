// One render on one device after the other, as long as devices fail.
#include "host/job/run_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <limits>
#include <new>
#include <thread>
#include <utility>

#include "host/base/interrupt.h"
#include "host/base/setting_words.h"
#include "host/image/image.h"
#include "host/job/checkpoints.h"
#include "host/job/film_identity.h"
#include "host/job/render_watch.h"
#include "host/job/resumption.h"
#include "host/job/sample_loop.h"

namespace candela::job {
namespace {

/// Counts the failures of one job's devices, and decides whether it tries again or ends.
class DeviceFailures {
 public:
  DeviceFailures(const Job& job, const Log& log) : job_(job), log_(log) {}

  int count() const { return count_; }
  /// Maximum size of a band's largest buffer: a quarter of the last one each time memory runs out.
  std::uint64_t maxBandBytes() const { return maxBandBytes_; }
  /// Target duration of a dispatch in seconds: a quarter of the last one each time the device is lost, because it may
  /// have been lost to a limit on the duration of work.
  double dispatchSeconds() const { return dispatchSeconds_; }

  /// Returns whether the job may go on: the device was lost, or memory ran out; after a first failure, also if the
  /// device is not found any more, and with a fallback if it was never found.
  bool isOne(const Error& error) const {
    if (is<NoDeviceError>(error)) return count_ > 0 || job_.film.fallback == Fallback::reference;
    return is<DeviceLostError>(error) || is<OutOfMemoryError>(error);
  }

  /// Counts a failure. Returns whether the device is to be opened again, after a pause that grows with each failure,
  /// and says so; at most three times in all. Devices that hang cannot be opened again while they do, and one that was
  /// never found is not searched for again.
  bool mayTryAgain(const Error& error) {
    if (is<OutOfMemoryError>(error)) limitBands();
    if (is<DeviceLostError>(error)) dispatchSeconds_ /= kShorterDispatches;
    const bool wasAbsent = is<NoDeviceError>(error) && count_ == 0;
    const bool isFinal = is<DeviceHungError>(error) || is<DeviceLimitError>(error) || wasAbsent;
    if (isFinal || count_ == kMaxAttempts) return false;
    ++count_;
    log_.warning(fmt::format("{}; the device is opened again (attempt {} of {})", error.what(), count_, kMaxAttempts));
    std::this_thread::sleep_for(pauseBefore(count_));
    return true;
  }

  /// Describes the failure after which there is no other attempt. `film` is the film file with the samples so far;
  /// empty if there is none.
  DeviceFailure describe(const Error& error, const std::string& film) const {
    const bool isMemory = is<OutOfMemoryError>(error);
    std::string text = error.what();
    if (count_ > 0) text += fmt::format("; opening the device again {} times did not help", count_);
    if (!film.empty()) {
      text += fmt::format("; {} contains the samples so far, and the same render with {} continues it", film,
                          settingWords("resume", film));
    }
    text += isMemory ? fmt::format("; close other programs that use the device, or render a smaller image ({} or {})",
                                   settingWords("size"), settingWords("crop"))
                     : "; candela doctor checks the device and its driver";
    if (job_.film.fallback == Fallback::none) {
      text += fmt::format(", and {} lets the reference tracer finish the render", settingWords("fallback", "cpu"));
    }
    return {isMemory ? ExitCode::outOfMemory : ExitCode::deviceLost, text};
  }

 private:
  static constexpr int kMaxAttempts = 3;
  static constexpr double kShorterDispatches = 4;

  template <class T>
  static bool is(const Error& error) {
    return dynamic_cast<const T*>(&error) != nullptr;
  }

  // A driver that resets its device needs time, especially after the second consecutive failure.
  static std::chrono::milliseconds pauseBefore(int attempt) {
    return std::chrono::milliseconds(attempt == 1 ? 0 : 500 * attempt);
  }

  // A pixel's state is below 256 bytes, so that the first step divides the image in bands, however large it is. One row
  // is always allowed.
  void limitBands() {
    constexpr std::uint64_t kBytesPerPixel = 256, kStep = 4, kBytesForOnePixel = 1024;
    const render::Window window = job_.settings.image.window();
    const std::uint64_t whole = std::uint64_t{window.width} * window.height * kBytesPerPixel;
    maxBandBytes_ = std::max(std::min(maxBandBytes_, whole) / kStep, window.width * kBytesForOnePixel);
  }

  const Job& job_;
  const Log& log_;
  int count_ = 0;
  std::uint64_t maxBandBytes_ = job_.settings.execution.maxBandBytes;
  double dispatchSeconds_ = job_.settings.execution.dispatchSeconds;
};

// Returns the name of a film file that does not exist yet, beside the file of a policy: "picture.png.film.exr". Empty
// if that is in no regular folder, or if too many such files exist.
std::filesystem::path rescueFile(const FilmPolicy& policy) {
  constexpr int kMaxFiles = 100;
  if (policy.rescueBeside.empty()) return {};
  const bool isStdout = image::isStandardOutput(policy.rescueBeside);
  const std::filesystem::path output = isStdout ? "candela" : policy.rescueBeside;
  std::error_code error;
  if (std::filesystem::exists(output, error) && !std::filesystem::is_regular_file(output, error)) return {};
  for (int i = 1; i <= kMaxFiles; ++i) {
    std::filesystem::path file = output;
    file += i == 1 ? ".film.exr" : fmt::format(".film-{}.exr", i);
    if (!std::filesystem::exists(file, error)) return file;
  }
  return {};
}

// Checks the file before the session is prepared, which takes time.
std::optional<film::FilmReader> openFilm(const Job& job) {
  if (job.film.resume.empty()) return std::nullopt;
  return film::FilmReader(job.film.resume);
}

double deadlineOf(const Job& job, double start) {
  return start + job.film.timeLimit.value_or(std::numeric_limits<double>::infinity());
}

/// The state from which a render continues: the first sample that it traces, and the work of earlier runs.
struct Inheritance {
  std::uint32_t firstSample = 0;
  film::WorkReport work;
};

/// The run of one job. Each attempt opens a renderer and prepares a session; if that fails, its film is salvaged, and
/// the next attempt continues it.
class JobRun {
 public:
  JobRun(const Job& job, const OpenDevice& open, const OpenDevice& openReference, const JobControl& control,
         const Log& log)
      : job_(job),
        open_(open),
        openReference_(openReference),
        log_(log),
        control_(control),
        range_(samplesOf(job)),
        settings_(job.settings),
        usesReference_(!open),
        reader_(openFilm(job)),
        watch_(deadlineOf(job, control.start), control.stop, control.writeRequested),
        failures_(job, log) {}

  JobResult run() {
    std::optional<JobResult> ended;
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

 private:
  bool hasFile() const { return !job_.film.checkpoint.empty(); }

  JobResult attempt() {
    begin();
    advance();
    return end();
  }

  void begin() {
    isReady_ = false;
    settings_.execution.maxBandBytes = failures_.maxBandBytes();
    settings_.execution.dispatchSeconds = failures_.dispatchSeconds();
    renderer_ = usesReference_ ? openReference_() : open_();
    session_ = renderer_->prepare(job_.scene(), settings_);
    loop_.emplace(*session_, watch_, [this](bool mustWrite) { pause(mustWrite); });
    if (salvaged_) {
      continueSalvagedFilm();
    } else {
      startOrResume();
    }
    isReady_ = true;
  }

  // The first session resumes the film file, if there is one.
  void startOrResume() {
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
    if (hasFile()) checkpoints_.emplace(checkpointsAt(job_.film.checkpoint));
  }

  // Later sessions continue the film of the previous one.
  void continueSalvagedFilm() {
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

  void load(const image::Film& film) {
    session_->load(film, inheritance_.firstSample);
    samplesBefore_ = film.counts().samples;
  }

  Checkpoints checkpointsAt(const std::filesystem::path& file) const {
    film::WorkReport before = inheritance_.work;
    before.add(lost_);
    return {job_.scene(), file, job_.film.checkpointEvery, header_, inheritance_.firstSample, before, log_};
  }

  void advance() {
    Progress line(std::cerr, control_.line);
    const auto report = [&](double fraction, std::uint64_t samples) {
      line.update(fraction, samples);
      if (control_.report) control_.report(fraction, samples);
    };
    FilmProgress progress(job_.settings.image.window().extent(), range_, samplesBefore_, report);
    scheduleWrite(monotonicSeconds());
    show();
    const auto plan = film::planOf(header_);
    isInterrupted_ = plan ? !loop_->traceAdaptively(*plan, range_.end, progress) : !loop_->trace(range_, progress);
  }

  // Work that was truncated must not reach a film file.
  void pause(bool mustWrite) {
    const double start = monotonicSeconds();
    const render::RenderStatistics statistics = session_->statistics();
    render::requireComplete(statistics);
    if (hasFile() && mustWrite) checkpoints_->write(loop_->storableFilm(), statistics, start);
    scheduleWrite(start);
    show();
  }

  // The film reaches the host when it is written; without a file, it is read from time to time, so that less is lost if
  // the device fails. Reading takes at most 1 % of the time.
  void scheduleWrite(double start) {
    constexpr double kMinSeconds = 10, kMinTimesItsCost = 100;
    const double now = monotonicSeconds();
    if (hasFile()) {
      watch_.writeAt(checkpoints_->nextWrite());
    } else if (!usesReference_) {
      watch_.writeAt(now + std::max(kMinSeconds, kMinTimesItsCost * (now - start)));
    }
  }

  // At most five times per second, which takes at most a tenth of the time.
  void show() {
    constexpr double kMinSeconds = 0.2, kMinTimesItsCost = 10;
    if (!control_.show) return;
    const double start = monotonicSeconds();
    control_.show(session_->film());
    const double end = monotonicSeconds();
    watch_.showAt(end + std::max(kMinSeconds, kMinTimesItsCost * (end - start)));
  }

  film::FilmHeader headerOf(const image::Film& film) const {
    film::FilmHeader header = header_;
    setContent(header, film, job_.scene(), inheritance_.firstSample);
    return header;
  }

  JobResult end() {
    JobResult ended;
    ended.result.interrupted = isInterrupted_;
    ended.result.film = loop_->storableFilm();
    ended.result.statistics = session_->statistics();
    render::requireComplete(ended.result.statistics);
    ended.header = headerOf(ended.result.film);
    ended.isTimeUp = isInterrupted_ && watch_.isTimeUp();
    if (control_.show) control_.show(ended.result.film);
    if (checkpoints_) {
      ended.isFilmLost = !checkpoints_->write(ended.result.film, ended.result.statistics, monotonicSeconds());
      ended.work = checkpoints_->work();
    } else if (reader_ || failures_.count() > 0) {
      ended.work = inheritance_.work;
      ended.work->add(lost_);
      ended.work->add(film::workOf(ended.result.statistics));
    }
    if (isInterrupted_) noteStop();
    return ended;
  }

  void noteStop() const {
    if (watch_.isTimeUp()) log_.note("the time limit is reached");
    if (isProcessorTimeUp()) log_.note("the limit of processor time (ulimit -t) is reached");
    if (hasFile()) {
      log_.note(fmt::format("the same render with {} continues the film",
                            settingWords("resume", job_.film.checkpoint.string())));
    }
  }

  // Returns nothing if the render continues.
  std::optional<JobResult> handle(const Error& error) {
    salvage();
    if (failures_.mayTryAgain(error) || fallBack(error)) return std::nullopt;
    return giveUp(error);
  }

  // Destroys the session after taking its film.
  void salvage() {
    if (isReady_) salvaged_ = session_->salvage();
    auto decided = loop_ ? loop_->takeDecided() : std::nullopt;
    if (salvaged_ && decided) salvaged_->film = std::move(*decided);
    loop_.reset();
    session_.reset();
    renderer_.reset();
    isReady_ = false;
    if (salvaged_) render::requireComplete(salvaged_->statistics);
    if (!salvaged_ && reader_) reader_.emplace(job_.film.resume);
  }

  bool fallBack(const Error& error) {
    if (job_.film.fallback != Fallback::reference || usesReference_) return false;
    log_.warning(fmt::format("{}; the reference tracer finishes the render", error.what()));
    usesReference_ = true;
    return true;
  }

  JobResult giveUp(const Error& error) {
    std::filesystem::path file;
    const bool hasSamples = salvaged_ && salvaged_->film.counts().samples > 0;
    if (hasSamples && !rescue(file)) file.clear();
    DeviceFailure failure = failures_.describe(error, file.string());
    if (!hasSamples) throw Error(failure.code, failure.message);
    JobResult ended;
    ended.result.interrupted = true;
    ended.result.film = std::move(salvaged_->film);
    ended.result.statistics = std::move(salvaged_->statistics);
    ended.header = headerOf(ended.result.film);
    if (checkpoints_) ended.work = checkpoints_->work();
    ended.isFilmLost = file.empty();
    ended.failure = std::move(failure);
    return ended;
  }

  // Writes the film to the checkpoint, or else to a file beside the output. Returns whether `file` has it.
  bool rescue(std::filesystem::path& file) {
    file = hasFile() ? job_.film.checkpoint : rescueFile(job_.film);
    if (file.empty()) return false;
    if (!checkpoints_) checkpoints_.emplace(checkpointsAt(file));
    return checkpoints_->write(salvaged_->film, salvaged_->statistics, monotonicSeconds());
  }

  const Job& job_;
  const OpenDevice& open_;
  const OpenDevice& openReference_;
  const Log& log_;
  const JobControl& control_;
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
  std::optional<Checkpoints> checkpoints_;   ///< with a checkpoint file, from the first session on
  std::optional<render::Salvage> salvaged_;  ///< of the last session that failed
  film::WorkReport lost_;                    ///< of all sessions that failed
  std::uint64_t samplesBefore_ = 0;          ///< in the film that the session resumed
  bool isInterrupted_ = false;
  std::optional<SampleLoop> loop_;  ///< around `session_`
};

}  // namespace

JobResult runJob(const Job& job, const OpenDevice& open, const JobControl& control, const Log& log,
                 const OpenDevice& openReference) {
  requirePossible(job.scene(), job.settings, job.film, false);
  return JobRun(job, open, openReference, control, log).run();
}

}  // namespace candela::job

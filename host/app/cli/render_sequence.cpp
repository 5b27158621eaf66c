// The loop over the frames of a sequence: what they share, which of them are missing, and their common progress.
#include "host/app/cli/render_sequence.h"

#include <fmt/format.h>

#include <iostream>
#include <set>
#include <string>
#include <vector>

#include "host/app/cli/frame_arguments.h"
#include "host/app/cli/output_check.h"
#include "host/app/cli/render_images.h"
#include "host/base/counted.h"
#include "host/base/interrupt.h"
#include "host/base/progress.h"
#include "host/base/setting_words.h"
#include "host/base/version.h"
#include "host/formats/load_scene.h"
#include "host/job/film_identity.h"
#include "host/job/frame_renderer.h"

namespace candela::cli {
namespace {

namespace fs = std::filesystem;

/// Passes on each warning, note and detail once, since most are the same for all frames.
class OnceLog final : public Log {
 public:
  explicit OnceLog(const Log& log) : Log(std::cerr, log.verbosity()), log_(log) {}

  void problem(const std::string& text) const override { log_.problem(text); }
  void warning(const std::string& text) const override {
    if (isNew(text)) log_.warning(text);
  }
  void note(const std::string& text) const override {
    if (isNew(text)) log_.note(text);
  }
  void detail(const std::string& text) const override { log_.detail(text); }

 private:
  bool isNew(const std::string& text) const { return seen_.insert(text).second; }

  const Log& log_;
  mutable std::set<std::string> seen_{};
};

/// Returns the pattern that continues the sequence: that of its films, or else of its first pictures; empty if it
/// writes neither.
fs::path resumedPattern(const RenderArguments& arguments) {
  if (!arguments.film.checkpoint.empty()) return arguments.film.checkpoint;
  return arguments.outputs.empty() ? fs::path() : arguments.outputs.front();
}

/// Locks the frames of all patterns of a sequence. Throws FileError if another process renders some of them.
std::vector<film::FilmLock> lockFrames(const RenderArguments& arguments) {
  const job::FrameRange frames = framesOf(arguments);
  std::vector<fs::path> patterns = arguments.outputs;
  if (!arguments.film.checkpoint.empty()) patterns.push_back(arguments.film.checkpoint);
  std::vector<film::FilmLock> locks;
  locks.reserve(patterns.size());
  for (const fs::path& pattern : patterns) locks.emplace_back(pattern, film::LockedPart{frames.first, frames.count()});
  return locks;
}

/// Films that exist are found before the first frame is rendered.
void requireNewFilms(const RenderArguments& arguments) {
  const job::FrameRange frames = framesOf(arguments);
  const fs::path& pattern = arguments.film.checkpoint;
  if (pattern.empty() || pattern == arguments.film.resume) return;
  for (std::uint32_t frame = frames.first; frame < frames.end; ++frame) {
    const fs::path film = job::frameFile(pattern, frame);
    std::error_code ignored;
    if (!fs::exists(film, ignored)) continue;
    throw FileError(
        fmt::format("{}: the file exists, and its samples would be lost; continue the sequence with {}, or remove it",
                    film.string(), settingWords("resume", pattern.string())));
  }
}

bool areNewer(const std::vector<fs::path>& files, const fs::path& other) {
  for (const fs::path& file : files) {
    std::error_code error;
    const auto time = fs::last_write_time(file, error);
    if (error || time < fs::last_write_time(other, error) || error) return false;
  }
  return true;
}

/// Throws FileError unless a picture may be that of this job. EXR files state how they were rendered.
void requirePictureOf(const RenderJob& job, const fs::path& file) {
  const image::Image picture = image::readImage(file);
  const render::Extent size = job.settings.image.window().extent();
  const auto refuse = [&](const std::string& difference) {
    throw FileError(fmt::format("{}: the picture is not of this sequence: {}; remove it, or choose other files",
                                file.string(), difference));
  };
  if (picture.width != size.width || picture.height != size.height) {
    refuse(fmt::format("it has {}x{} pixels, and the frame {}", picture.width, picture.height, extentText(size)));
  }
  for (const auto& [name, value] : metadataOf(job, {})) {
    const auto found = picture.metadata.find(name);
    const bool isOfRender = name == "candela.filmHash" || name == "candela.device" || name == "candela.driver";
    if (found == picture.metadata.end() || isOfRender || found->second == value) continue;
    refuse(fmt::format("its {} is {}, and that of the frame {}", name, found->second, value));
  }
}

class Sequence {
 public:
  Sequence(const RenderArguments& arguments, const Log& log)
      : arguments_(arguments),
        log_(log),
        frames_(framesOf(arguments)),
        renderer_(openDevice(arguments, log_)),
        line_(std::cerr, progressStyle(log.verbosity())) {}

  ExitCode render() {
    const std::atomic<bool>& stop = watchInterrupts();
    const RenderSteps steps = stepsOf();
    for (frame_ = frames_.first; frame_ < frames_.end; ++frame_) {
      const ExitCode code = stop ? ExitCode::interrupted : renderFrame(steps);
      if (code != ExitCode::done) return stopAt(code);
      doneSamples_ += frameSamples_;
      frameSamples_ = 0;
    }
    summarise();
    return ExitCode::done;
  }

 private:
  void summarise() {
    line_.clear();
    std::string text = counted(frames_.count(), "frame");
    if (skippedCount_ > 0) text += fmt::format(", of which {} existed", skippedCount_);
    text += fmt::format(", {}", durationText(monotonicSeconds() - start_));
    if (!device_.empty()) text += " on " + device_;
    log_.note(text);
  }

  RenderSteps stepsOf() {
    RenderSteps steps;
    steps.isFrame = true;
    steps.control.start = start_;
    steps.control.report = [this](double fraction, std::uint64_t samples) { report(fraction, samples); };
    steps.load = [this](const RenderArguments& one) { return load(one); };
    steps.trace = [this](const RenderJob& job, const job::JobControl& control) { return trace(job, control); };
    steps.isDone = [this](const RenderArguments& one, const RenderJob& job) { return isDone(one, job); };
    return steps;
  }

  ExitCode renderFrame(const RenderSteps& steps) {
    try {
      return renderImage(argumentsOfFrame(arguments_, frame_), steps, log_);
    } catch (const Error&) {
      line_.clear();
      if (frame_ > frames_.first) log_.problem(fmt::format("frame {} failed", frame_));
      throw;
    }
  }

  RenderJob load(const RenderArguments& one) {
    line_.clear();  // warnings and notes may follow
    const double start = monotonicSeconds();
    if (!source_) source_.emplace(one.files.front(), one.loadOptions);
    scene::LoadedScene loaded = source_->at(one.loadOptions.time, one.loadOptions.orbit);
    acceptScene(loaded, one, log_);
    noteEnd(loaded.animationEnd);
    const double seconds = monotonicSeconds() - start;
    RenderJob job = jobOf(one, std::make_shared<const scene::Scene>(std::move(loaded.scene)), log_);
    job.parseSeconds = seconds;
    return job;
  }

  void noteEnd(const std::optional<double>& end) {
    if (!hasTimes(arguments_)) return;
    if (!end) {
      log_.note(settingWords("turntable", "N") + " turns the camera about a scene without an animation");
    } else if ((frames_.end - 1) / arguments_.framesPerSecond > *end) {
      log_.note(fmt::format("the animation ends at {:g} s; later frames show its last pose", *end));
    }
  }

  bool isDone(const RenderArguments& one, const RenderJob& job) {
    const bool isDone = resumesPictures(arguments_) ? hasPictures(one, job) : hasFilm(one, job);
    if (isDone) ++skippedCount_;
    return isDone;
  }

  static bool hasPictures(const RenderArguments& one, const RenderJob& job) {
    std::error_code ignored;
    for (const fs::path& output : one.outputs) {
      if (!fs::exists(output, ignored)) return false;
    }
    for (const fs::path& output : one.outputs) requirePictureOf(job, output);
    return true;
  }

  /// The tracer of the film is compared with that of the other frames, since no device is open yet.
  bool hasFilm(const RenderArguments& one, const RenderJob& job) {
    if (one.film.resume.empty() || !areNewer(one.outputs, one.film.resume)) return false;
    if (job.settings.image.integrator == render::Integrator::cost) return false;
    const film::FilmReader reader(one.film.resume);
    const film::FilmHeader& film = reader.header();
    const film::FilmHeader header = filmHeaderOf(job, {});
    const bool isSame = estimateDifferences(film, header, "the film", "the frame").empty() &&
                        film.samplesPerPixel == header.samplesPerPixel && film.window == header.window;
    if (!isSame || !film.begun.empty() || film.covered != coveredBy(job)) return false;
    compareTracers(film);
    return true;
  }

  /// Returns the samples of a film of this job that is finished.
  static std::vector<film::SampleBox> coveredBy(const RenderJob& job) {
    const render::Window window = job.settings.image.window();
    return {{window, samplesOf(job)}};
  }

  void compareTracers(const film::FilmHeader& film) {
    if (tracers_.empty()) tracers_ = film.tracers;
    if (film.tracers == tracers_) return;
    log_.warning(fmt::format("frame {} was not rendered by the same device, driver and program as the frames before it",
                             frame_));
    tracers_ = film.tracers;
  }

  job::JobResult trace(const RenderJob& job, const job::JobControl& control) {
    job::JobResult result = renderer_.run(job, control, log_);
    compareTracers(result.header);
    device_ = result.result.statistics.device;
    return result;
  }

  /// Frames that existed do not count.
  void report(double fraction, std::uint64_t samples) {
    const std::uint32_t before = frame_ - frames_.first;
    frameSamples_ = samples;
    line_.update((before - skippedCount_ + fraction) / (frames_.count() - skippedCount_), doneSamples_ + samples,
                 fmt::format("frame {} of {}:{}, ", frame_, frames_.first, frames_.end));
  }

  ExitCode stopAt(ExitCode code) {
    line_.clear();
    std::string text = fmt::format("the sequence ends before frame {} of {}:{} is done", frame_, frames_.first,
                                   frames_.end);
    const fs::path pattern = resumedPattern(arguments_);
    if (!pattern.empty()) {
      text += fmt::format("; the same command with {} continues it", settingWords("resume", pattern.string()));
    }
    log_.note(text);
    return code;
  }

  const RenderArguments& arguments_;
  OnceLog log_;
  job::FrameRange frames_;
  job::FrameRenderer renderer_;
  Progress line_;
  double start_ = monotonicSeconds();
  std::optional<formats::SceneSource> source_{};
  std::uint32_t frame_ = 0;
  std::uint32_t skippedCount_ = 0;
  std::uint64_t doneSamples_ = 0, frameSamples_ = 0;
  std::vector<film::Tracer> tracers_{};  ///< of the last frame
  std::string device_;                   ///< that rendered the last frame; empty: all frames existed
};

}  // namespace

ExitCode renderSequence(const RenderArguments& arguments, const Log& log) {
  const std::uint32_t first = framesOf(arguments).first;
  for (const fs::path& output : arguments.outputs) requireWritableImage(job::frameFile(output, first));
  const std::vector<film::FilmLock> locks = lockFrames(arguments);
  requireNewFilms(arguments);
  return Sequence(arguments, log).render();
}

}  // namespace candela::cli

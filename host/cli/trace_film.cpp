// The loop around a session: advance until something is to be done, do it, go on.
#include "host/cli/trace_film.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <limits>

#include "host/cli/checkpoints.h"
#include "host/cli/film_identity.h"
#include "host/cli/option_table.h"
#include "host/cli/render_watch.h"

namespace candela::cli {
namespace {

// The state from which a render goes on: the first sample that it traces, and the work of earlier runs.
struct Inheritance {
  std::uint32_t firstSample = 0;
  film::WorkReport work;
};

// Checks what the scene and the options tell before the session is prepared, which takes time.
std::optional<film::FilmReader> openFilm(const RenderJob& job) {
  if (job.arguments.resume.empty()) return std::nullopt;
  return film::FilmReader(job.arguments.resume);
}

Inheritance inherit(const RenderJob& job, std::optional<film::FilmReader>& reader, render::Session& session,
                    film::FilmHeader& header, const Log& log) {
  Inheritance inheritance{samplesOf(job).first, {}};
  if (!reader) return inheritance;
  inheritance.work = film::readWork(reader->file(), reader->check());
  if (adoptFilm(job, *reader, header, log)) session.load(film::readFilm(*reader), inheritance.firstSample);
  return inheritance;
}

std::uint64_t sampleCount(const image::Film& film) {
  std::uint64_t samples = 0;
  for (const image::FilmPixel& pixel : film.pixels()) samples += pixel.sampleCount;
  return samples;
}

/// Reports progress over all calls of advance(), and over earlier runs.
class FilmProgress {
 public:
  FilmProgress(const RenderJob& job, const render::SampleRange& range, std::uint64_t samplesBefore, Progress& progress)
      : progress_(progress),
        total_(static_cast<double>(job.settings.image.window().width) * job.settings.image.window().height *
               (range.end - range.first)),
        before_(samplesBefore) {}

  void update(std::uint64_t samplesDone) {
    current_ = samplesDone;
    const double done = static_cast<double>(before_ + earlier_ + current_);
    progress_.update(std::min(1.0, done / total_), earlier_ + current_);
  }
  void endOfCall() {
    earlier_ += current_;
    current_ = 0;
  }

 private:
  Progress& progress_;
  double total_;
  std::uint64_t before_;
  std::uint64_t earlier_ = 0, current_ = 0;
};

// Work that was truncated must not reach a film file.
void writeDuring(render::Session& session, Checkpoints& checkpoints) {
  const double start = monotonicSeconds();
  const render::RenderStatistics statistics = session.statistics();
  requireComplete(statistics);
  checkpoints.write(session.film(), statistics, start);
}

void noteStop(const RenderJob& job, const RenderWatch& watch, const Log& log) {
  if (watch.isTimeUp()) log.note("--time-limit: the time is up");
  if (job.arguments.checkpoint.empty()) return;
  const std::string file = shellQuoted(job.arguments.checkpoint.string());
  log.note(fmt::format("the same command with --resume {} goes on", file));
}

double deadlineOf(const RenderJob& job, double start) {
  return start + job.arguments.timeLimit.value_or(std::numeric_limits<double>::infinity());
}

}  // namespace

TracedFilm traceFilm(const RenderJob& job, double start, const Log& log) {
  const render::SampleRange range = samplesOf(job);
  const std::filesystem::path& checkpoint = job.arguments.checkpoint;
  std::optional<film::FilmReader> reader = openFilm(job);
  RenderWatch watch(deadlineOf(job, start), !checkpoint.empty());
  const std::unique_ptr<render::Renderer> renderer = makeRenderer(job.arguments, log);
  const std::unique_ptr<render::Session> session = renderer->prepare(job.scene, job.settings);
  film::FilmHeader header = filmHeaderOf(job, session->statistics());
  const Inheritance inheritance = inherit(job, reader, *session, header, log);
  Checkpoints checkpoints(checkpoint, job.arguments.checkpointEvery, header, inheritance.firstSample, inheritance.work,
                          log);
  if (!checkpoint.empty()) watch.writeAt(checkpoints.nextWrite());

  Progress progress(std::cerr, progressStyle(log.verbosity()));
  FilmProgress filmProgress(job, range, reader ? sampleCount(session->film()) : 0, progress);
  const render::RenderControl control{&watch.stop(),
                                      [&](double, std::uint64_t samples) { filmProgress.update(samples); }};
  TracedFilm traced;
  while (!session->advance(range, control)) {
    traced.result.interrupted = watch.mustEnd();
    if (traced.result.interrupted) break;
    filmProgress.endOfCall();
    watch.goOn();
    writeDuring(*session, checkpoints);
    watch.writeAt(checkpoints.nextWrite());
  }
  traced.result.film = session->film();
  traced.result.statistics = session->statistics();
  requireComplete(traced.result.statistics);
  if (!checkpoint.empty()) {
    traced.isFilmLost = !checkpoints.write(traced.result.film, traced.result.statistics, monotonicSeconds());
    traced.work = checkpoints.work();
  } else if (reader) {
    traced.work = inheritance.work;
    traced.work->add(film::workOf(traced.result.statistics));
  }
  if (traced.result.interrupted) noteStop(job, watch, log);
  return traced;
}

}  // namespace candela::cli

// Advances a session, and describes its film.
#include "host/app/python/session.h"

#include <algorithm>

#include "host/app/python/rendering.h"
#include "host/base/progress.h"
#include "host/job/film_identity.h"

namespace candela::python {

PythonSession::PythonSession(const PythonScene& scene, const cli::RenderArguments& arguments,
                             std::shared_ptr<PythonLog> log)
    : arguments_(arguments),
      job_(renderJobOf(scene, arguments, *log)),
      files_(scene.files()),
      log_(std::move(log)),
      renderer_(makeRenderer(job_.arguments, *log_)),
      session_(renderer_->prepare(job_.scene(), job_.settings)) {}

render::SampleRange PythonSession::next(std::uint32_t count) const {
  return {done_, done_ + std::min(count, total() - done_)};
}

bool PythonSession::advance(const std::optional<render::SampleRange>& range, const Watch& watch) {
  const double start = monotonicSeconds();
  const render::SampleRange wanted = range.value_or(render::SampleRange{done_, total()});
  job::requireSamples(wanted, total());
  if (wanted.first == wanted.end) return true;
  const bool isComplete = session_->advance(wanted, {&watch.stop, watch.report});
  if (!first_) first_ = wanted.first;
  wanted_ = std::max(wanted_, wanted.end);
  if (isComplete) {
    const render::Extent size = job_.settings.image.window().extent();
    done_ = std::max(done_, wanted.end);
    watch.report(1, std::uint64_t{size.width} * size.height * (wanted.end - wanted.first));
  }
  seconds_ += monotonicSeconds() - start;
  return isComplete;
}

// Returns the render as on a command line: with --samples, if it is a part.
cli::RenderJob PythonSession::jobSoFar() const {
  cli::RenderJob job = job_;
  const std::uint32_t first = first_.value_or(0);
  if (first > 0 || wanted_ < total()) job.film.samples = render::SampleRange{first, wanted_};
  return job;
}

std::shared_ptr<PythonFilm> PythonSession::film() {
  render::RenderResult result{.film = session_->film(), .statistics = session_->statistics(), .paths = {}};
  render::requireComplete(result.statistics);
  result.interrupted = done_ < wanted_;
  const cli::RenderJob job = jobSoFar();
  film::FilmHeader header = job::filmHeaderOf(job, result.statistics);
  job::setContent(header, result.film, job.scene(), first_.value_or(0));
  const film::WorkReport work = film::workOf(result.statistics);
  return filmOf(job, arguments_, files_, std::move(result), std::move(header), work, seconds_, *log_);
}

void PythonSession::reset(std::uint32_t seed) {
  session_->reset(seed, total());
  job_.settings.image.seed = seed;
  first_.reset();
  done_ = wanted_ = 0;
  seconds_ = 0;
}

}  // namespace candela::python

// Continues a render after its device failed, or saves the film so far.
#include <fmt/format.h>

#include "host/cli/film_identity.h"
#include "host/cli/film_resumption.h"
#include "host/cli/film_trace.h"
#include "host/cli/rescue_file.h"

namespace candela::cli {

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

}  // namespace candela::cli

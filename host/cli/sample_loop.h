// Advances a session to the end of its samples.
#pragma once
#include <functional>
#include <optional>
#include <utility>

#include "host/cli/film_progress.h"
#include "host/cli/render_watch.h"
#include "host/render/adaptive_plan.h"
#include "host/render/session.h"

namespace candela::cli {

/// The loop around one session, which stops where the watch says so.
class SampleLoop {
 public:
  /// `pause` is called whenever the watch requests a pause, with whether the film must be written. The arguments
  /// must outlive the object.
  SampleLoop(render::Session& session, RenderWatch& watch, std::function<void(bool mustWrite)> pause)
      : session_(session), watch_(watch), pause_(std::move(pause)) {}

  /// Traces these samples of all pixels that the session does not leave out. Returns false if the render is
  /// interrupted.
  bool trace(const render::SampleRange& range, FilmProgress& progress);
  /// Traces as many of `maxSamples` samples as the plan requires. Returns false if the render is interrupted.
  bool traceAdaptively(const render::AdaptivePlan& plan, std::uint32_t maxSamples, FilmProgress& progress);

  /// Returns the film that may be stored now.
  image::Film storableFilm() { return decided_ ? *decided_ : session_.film(); }
  /// The film of the last decision of adaptive sampling, as long as that of the session does not show the decision.
  std::optional<image::Film> takeDecided() { return std::exchange(decided_, std::nullopt); }

 private:
  render::Session& session_;
  RenderWatch& watch_;
  std::function<void(bool)> pause_;
  std::optional<image::Film> decided_;
};

}  // namespace candela::cli

// Advances a session to the end of its samples.
#pragma once
#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>

#include "host/job/render_watch.h"
#include "host/trace/render/adaptive_plan.h"
#include "host/trace/render/session.h"

namespace candela::job {

/// Reports the fraction of a range of samples that is done over all calls of Session::advance(), including samples of
/// earlier runs.
class FilmProgress {
 public:
  /// `report` gets the fraction and the number of samples that this process has traced.
  using Report = std::function<void(double fraction, std::uint64_t samples)>;

  /// `size` is that of the film.
  FilmProgress(const render::Extent& size, const render::SampleRange& range, std::uint64_t samplesBefore, Report report)
      : report_(std::move(report)),
        total_(static_cast<double>(size.width) * size.height * (range.end - range.first)),
        before_(samplesBefore) {}

  void update(std::uint64_t samplesDone) {
    current_ = samplesDone;
    const double done = static_cast<double>(before_ + earlier_ + current_ + skipped_);
    report_(std::min(1.0, done / total_), earlier_ + current_);
  }
  /// Sets the number of samples that will not be traced.
  void skip(std::uint64_t samples) { skipped_ = samples; }
  void endOfCall() {
    earlier_ += current_;
    current_ = 0;
  }

 private:
  Report report_;
  double total_;
  std::uint64_t before_;
  std::uint64_t earlier_ = 0, current_ = 0, skipped_ = 0;
};

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

}  // namespace candela::job

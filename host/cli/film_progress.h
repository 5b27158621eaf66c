// The progress of a render over all calls of Session::advance().
#pragma once
#include <algorithm>
#include <cstdint>

#include "host/cli/render_job.h"
#include "host/core/progress.h"

namespace candela::cli {

/// Reports the share of a range of samples that is done, samples of earlier runs included.
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

}  // namespace candela::cli

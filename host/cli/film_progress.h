// The progress of a render over all calls of Session::advance().
#pragma once
#include <algorithm>
#include <cstdint>
#include <functional>
#include <utility>

#include "host/cli/render_job.h"

namespace candela::cli {

/// Reports the fraction of a range of samples that is done, including samples of earlier runs.
class FilmProgress {
 public:
  /// `report` gets the fraction and the number of samples that this process has traced.
  using Report = std::function<void(double fraction, std::uint64_t samples)>;

  FilmProgress(const RenderJob& job, const render::SampleRange& range, std::uint64_t samplesBefore, Report report)
      : report_(std::move(report)),
        total_(static_cast<double>(job.settings.image.window().width) * job.settings.image.window().height *
               (range.end - range.first)),
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

}  // namespace candela::cli

// Repeats untimed work until its rate no longer rises.
#include "host/measure/bench/warm_up.h"

#include <fmt/format.h>

#include <atomic>

#include "host/base/stopwatch.h"

namespace candela::bench {

std::string repetitionText(std::uint32_t repeats, const WarmUpWork& all, std::size_t runs) {
  const std::string text = fmt::format("median of {}, runs interleaved", repeats);
  if (all.passes == 0) return text;
  return text + fmt::format(", each after a warm-up of {:.2f} s", all.seconds / static_cast<double>(runs));
}

void WarmUp::add(double seconds, double amount) {
  work_.add({seconds, 1});
  windowSeconds_ += seconds;
  windowAmount_ += amount;
  if (windowSeconds_ < kWarmUpWindow) return;
  const double rate = windowAmount_ / windowSeconds_;
  isStable_ = rate_ && rate <= *rate_ * (1 + kWarmUpTolerance);
  rate_ = rate;
  windowSeconds_ = windowAmount_ = 0;
}

std::optional<WarmUpWork> warmUp(render::Session& session, const render::ImageSettings& image,
                                 const render::RenderControl& control) {
  WarmUp warmUp;
  if (!session.statistics().onGpu) return warmUp.work();
  // The time of the device alone would not bound the warm-up of tiny images, most of whose time passes on the host.
  Stopwatch watch;
  double elapsed = 0;
  std::atomic<bool> stop = false;
  const auto isInterrupted = [&] { return control.stop != nullptr && *control.stop; };
  render::RenderControl pass;
  pass.stop = &stop;
  pass.progress = [&](double, std::uint64_t) {
    elapsed += watch.lap();
    if (elapsed >= kMaxWarmUpSeconds || isInterrupted()) stop = true;
  };
  while (!warmUp.isDone() && !stop) {
    session.advance({0, image.sampleCount}, pass);
    if (isInterrupted()) return std::nullopt;
    render::RenderStatistics statistics = session.statistics();
    warmUp.add(statistics.seconds["trace"], static_cast<double>(statistics.samples));
    session.reset(image.seed, image.sampleCount);
  }
  return warmUp.work();
}

}  // namespace candela::bench

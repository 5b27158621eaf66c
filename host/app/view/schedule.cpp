// Chooses resolutions and numbers of samples by measured speeds.
#include "host/app/view/schedule.h"

#include <algorithm>

#include "host/base/divide_up.h"

namespace candela::view {
namespace {

constexpr std::uint32_t kUnknownScale = 8;  // of the first picture, before a speed is known

// Ranks the progress of a side: nothing, then pictures from coarse to fine, then samples.
std::uint64_t rankOf(std::uint32_t scale, std::uint32_t samples) {
  if (scale == 0) return 0;
  return scale > 1 ? kMaxScale / scale : std::uint64_t{kMaxScale} + samples;
}

}  // namespace

render::Extent scaled(const render::Extent& size, std::uint32_t scale) {
  return {divideUp(size.width, scale), divideUp(size.height, scale)};
}

void Schedule::restart() {
  for (State& state : sides_) {
    state.scale = 0;
    state.samples = 0;
  }
}

double Schedule::pixels(std::uint32_t scale) const {
  const render::Extent size = scaled(size_, scale);
  return static_cast<double>(size.width) * size.height;
}

bool Schedule::isBehind(const State& a, const State& b) const {
  return rankOf(a.scale, a.samples) < rankOf(b.scale, b.samples);
}

std::uint32_t Schedule::firstScale(const State& state) const {
  if (state.secondsPerSample == 0) return kUnknownScale;
  std::uint32_t scale = 1;
  while (scale < kMaxScale && pixels(scale) * state.secondsPerSample > kPreviewSeconds) scale *= 2;
  return scale;
}

std::uint32_t Schedule::nextSampleEnd(const State& state) const {
  for (const State& other : sides_) {
    if (other.isWanted && other.scale == 1 && other.samples > state.samples) return other.samples;
  }
  double cost = 0;
  for (const State& side : sides_) cost += side.isWanted ? side.secondsPerSample * pixels(1) : 0;
  const double fitting = std::clamp(kStepSeconds / std::max(cost, 1e-9), 1.0, std::max(1.0, 1.0 * state.samples));
  return static_cast<std::uint32_t>(
      std::min<std::uint64_t>(state.samples + static_cast<std::uint64_t>(fitting), sampleCount_));
}

std::optional<Step> Schedule::next() const {
  std::optional<Side> behind;
  const Side other = preferred_ == Side::device ? Side::reference : Side::device;
  for (const Side side : {preferred_, other}) {
    if (!isWanted(side) || (scale(side) == 1 && samples(side) >= sampleCount_)) continue;
    if (!behind || isBehind(stateOf(side), stateOf(*behind))) behind = side;
  }
  if (!behind) return std::nullopt;
  const State& state = stateOf(*behind);
  if (state.scale == 1) return Step{*behind, 1, nextSampleEnd(state)};
  return Step{*behind, state.scale == 0 ? firstScale(state) : state.scale / 2, 1};
}

void Schedule::finish(const Step& step, double seconds) {
  preferred_ = step.side == Side::device ? Side::reference : Side::device;
  State& state = stateOf(step.side);
  const std::uint32_t before = state.scale == step.scale ? state.samples : 0;
  const double traced = pixels(step.scale) * (step.sampleEnd - before);
  state.secondsPerSample = seconds / std::max(traced, 1.0);
  state.scale = step.scale;
  state.samples = step.scale == 1 ? step.sampleEnd : 0;
}

bool Schedule::isLevel() const {
  const State& a = stateOf(Side::device);
  const State& b = stateOf(Side::reference);
  return a.isWanted && b.isWanted && a.scale == 1 && b.scale == 1 && a.samples == b.samples;
}

}  // namespace candela::view

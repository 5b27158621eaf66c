// The order in which a viewer renders: coarse pictures first, then all pixels, then more samples, by one tracer or two.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "host/trace/render/extent.h"

namespace candela::view {

/// The two tracers of a viewer.
enum class Side : std::size_t { device, reference };
inline constexpr std::size_t kSideCount = 2;
constexpr std::size_t indexOf(Side side) { return static_cast<std::size_t>(side); }

/// One call of Session::advance(): samples [0, sampleEnd) of each pixel of an image whose sides are divided by `scale`.
struct Step {
  Side side = Side::device;
  std::uint32_t scale = 1;  ///< a power of two, at most kMaxScale
  std::uint32_t sampleEnd = 1;

  bool operator==(const Step&) const = default;
};

inline constexpr std::uint32_t kMaxScale = 16;

/// Returns the size of an image whose sides are divided by `scale`, rounded up.
render::Extent scaled(const render::Extent& size, std::uint32_t scale);

/// After every change of the view, each wanted side starts with a picture so coarse that it takes at most
/// kPreviewSeconds, and continues with twice the resolution, until all pixels have one sample. Then the number of
/// samples grows, in steps of about kStepSeconds that at most double it. If both sides are requested, the one with less
/// progress continues, and both stop at the same numbers of samples; sides of equal progress alternate. It has no
/// clock: durations are passed to it.
class Schedule {
 public:
  static constexpr double kPreviewSeconds = 0.015;
  static constexpr double kStepSeconds = 0.1;

  /// `sampleCount` is the number of samples per pixel at which the render ends, > 0.
  Schedule(const render::Extent& size, std::uint32_t sampleCount) : size_(size), sampleCount_(sampleCount) {}

  /// Starts again, since the picture of every side is out of date. Measured speeds are preserved.
  void restart();
  void setWanted(Side side, bool isWanted) { stateOf(side).isWanted = isWanted; }
  bool isWanted(Side side) const { return stateOf(side).isWanted; }

  /// Returns the next step; nothing if all requested sides have all samples.
  std::optional<Step> next() const;
  /// Records that a step is finished, and the seconds that it took.
  void finish(const Step& step, double seconds);

  /// Samples that each pixel has in full resolution.
  std::uint32_t samples(Side side) const { return stateOf(side).samples; }
  /// Scale of the last finished picture; 0: there is none.
  std::uint32_t scale(Side side) const { return stateOf(side).scale; }
  /// Returns whether both sides are wanted and have the same number of samples in full resolution, at least one.
  bool isLevel() const;

 private:
  struct State {
    bool isWanted = false;
    std::uint32_t scale = 0;
    std::uint32_t samples = 0;
    double secondsPerSample = 0;  ///< 0: unknown
  };
  State& stateOf(Side side) { return sides_[indexOf(side)]; }
  const State& stateOf(Side side) const { return sides_[indexOf(side)]; }
  bool isBehind(const State& a, const State& b) const;
  std::uint32_t firstScale(const State& state) const;
  std::uint32_t nextSampleEnd(const State& state) const;
  double pixels(std::uint32_t scale) const;

  render::Extent size_;
  std::uint32_t sampleCount_;
  std::array<State, kSideCount> sides_;
  Side preferred_ = Side::device;  ///< where none is behind
};

}  // namespace candela::view

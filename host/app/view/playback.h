// Plays an animation in a viewer: which time is shown when.
#pragma once

namespace candela::view {

/// Repeats an animation from 0 to its end, at the speed of the clock. All times are in seconds.
class Playback {
 public:
  static constexpr double kFramesPerSecond = 24;

  bool isPlaying() const { return isPlaying_; }
  /// Starts at a time of the animation. `now` is that of a monotonic clock.
  void play(double time, double now);
  void pause() { isPlaying_ = false; }
  /// Returns the time of the frame that is to be shown now: a multiple of 1 / kFramesPerSecond below `end`, which is
  /// above 0. Frames for which there is no time are left out.
  double timeAt(double now, double end) const;

 private:
  bool isPlaying_ = false;
  double start_ = 0;  ///< time of the clock at which the animation was, or would have been, at 0
};

}  // namespace candela::view

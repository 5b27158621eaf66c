// Converts times of the clock to those of an animation.
#include "host/app/view/playback.h"

#include <cmath>

namespace candela::view {

void Playback::play(double time, double now) {
  isPlaying_ = true;
  start_ = now - time;
}

double Playback::timeAt(double now, double end) const {
  return std::floor(std::fmod(now - start_, end) * kFramesPerSecond) / kFramesPerSecond;
}

}  // namespace candela::view

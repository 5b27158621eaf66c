// Times of an animation that is played.
#include "host/app/view/playback.h"

#include <catch2/catch.hpp>

namespace candela::view {

TEST_CASE("an animation is played in frames at the speed of the clock, and repeated") {
  Playback playback;
  CHECK_FALSE(playback.isPlaying());
  playback.play(0.5, 100);
  CHECK(playback.isPlaying());
  CHECK(playback.timeAt(100, 2) == 0.5);
  CHECK(playback.timeAt(100.04, 2) == 0.5);
  CHECK(playback.timeAt(100.05, 2) == 13 / 24.0);
  CHECK(playback.timeAt(101.25, 2) == 1.75);
  CHECK(playback.timeAt(101.75, 2) == 0.25);
  CHECK(playback.timeAt(107.5, 2) == 0);
  playback.pause();
  CHECK_FALSE(playback.isPlaying());
}

}  // namespace candela::view

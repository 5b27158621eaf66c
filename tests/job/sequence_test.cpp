// Names of the files of frames.
#include "host/job/sequence.h"

#include <catch2/catch.hpp>

namespace candela::job {

TEST_CASE("the number of a frame replaces the last run of # in the name of a file") {
  CHECK(frameFile("out/frame.####.png", 7) == "out/frame.0007.png");
  CHECK(frameFile("####", 12) == "0012");
  CHECK(frameFile("a#.exr", 120) == "a120.exr");
  CHECK(frameFile("take##_###.png", 3) == "take##_003.png");
  CHECK(frameFile("##/a.png", 3) == "##/a.png");
  CHECK(frameFile("", 3) == "");
  CHECK(isFramePattern("b/#.png"));
  CHECK_FALSE(isFramePattern("#/b.png"));
}

}  // namespace candela::job

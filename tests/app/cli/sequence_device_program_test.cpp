// Sequences of frames on a Vulkan device, whose sessions stay from frame to frame.
#include <catch2/catch.hpp>
#include <cstdlib>

#include "tests/app/cli/sequence_runs.h"

namespace candela {
namespace {

SequenceRuns deviceFrames() {
  SequenceRuns runs{{"--size", "24x18", "--spp", "4"}};
  if (const char* device = std::getenv("CANDELA_TEST_DEVICE")) {
    runs.common.insert(runs.common.end(), {"--device", device});
  }
  return runs;
}

}  // namespace

TEST_CASE("each frame of a sequence on a device has the bytes of a single render", "[swiftshader-slow]") {
  requireFramesOfSingleRenders(deviceFrames());
}

TEST_CASE("a sequence on a device is resumed from its films", "[swiftshader-slow]") {
  requireResumption(deviceFrames());
}

}  // namespace candela

// Command lines that `candela explain` refuses before it opens a device.
#include <catch2/catch.hpp>

#include "tests/app/cli/run_program.h"

namespace candela {
namespace {

using Catch::Contains;

// Runs on a device that does not exist: options are refused before this is detected, which would exit with 4.
ProgramResult refuse(const std::vector<std::string>& options) {
  const TemporaryFolder folder;
  std::vector<std::string> words{"explain", folder.write("a.p3f", smallScene()), "--device", "nosuch"};
  words.insert(words.end(), options.begin(), options.end());
  ProgramResult result = runCandela(words, withDrivers());
  CHECK(folder.fileCount() == 1);
  CHECK(result.out.empty());
  return result;
}

}  // namespace

TEST_CASE("explain refuses a pixel outside the image and names its limits") {
  for (const char* pixel : {"16,0", "0,12", "65534,65534"}) {
    const ProgramResult result = refuse({"--pixel", pixel});
    CHECK(result.exitCode == 1);
    CHECK_THAT(result.err, Contains("outside the image of 16x12 pixels (0,0 to 15,11)"));
  }
  CHECK(refuse({"--pixel", "15,11"}).exitCode == 4);
  CHECK(refuse({"--pixel", "16,0", "--size", "17x1"}).exitCode == 4);
}

TEST_CASE("explain refuses a value that is no pixel") {
  for (const char* pixel : {"3", "3x4", "-1,0", "3,", ",4", "3,4,5", "1.5,2", "a,b"}) {
    CAPTURE(pixel);
    const ProgramResult result = refuse({std::string("--pixel=") + pixel});
    CHECK(result.exitCode == 1);
    CHECK_THAT(result.err, Contains("--pixel: expected X,Y with both from 0 to 65534"));
  }
}

TEST_CASE("explain refuses a sample index that the pixel does not have, and one without a pixel") {
  const ProgramResult beyond = refuse({"--pixel", "1,1", "--sample", "16"});
  CHECK(beyond.exitCode == 1);
  CHECK_THAT(beyond.err, Contains("a pixel has 16 samples (0 to 15); use --spp 17 or more"));
  CHECK(refuse({"--pixel", "1,1", "--sample", "15"}).exitCode == 4);
  CHECK(refuse({"--pixel", "1,1", "--sample", "16", "--spp", "17"}).exitCode == 4);
  const ProgramResult nowhere = refuse({"--sample", "2"});
  CHECK(nowhere.exitCode == 1);
  CHECK_THAT(nowhere.err, Contains("--sample needs --pixel; without"));
}

TEST_CASE("explain refuses the reference as the device, and integrators without paths") {
  const ProgramResult itself = refuse({"--device", "cpu"});
  CHECK(itself.exitCode == 1);
  CHECK_THAT(itself.err, Contains("the reference tracer cannot be compared with itself"));
  const ProgramResult whitted = refuse({"--integrator", "whitted"});
  CHECK(whitted.exitCode == 1);
  CHECK_THAT(whitted.err, Contains("`candela compare SCENE`"));
  const TemporaryFolder folder;
  const ProgramResult verify = runCandela(
      {"verify", folder.write("a.p3f", smallScene()), "--explain", "--integrator", "normal", "--device", "nosuch"});
  CHECK(verify.exitCode == 1);
  CHECK_THAT(verify.err, Contains("only samples of the path tracer can be explained"));
}

}  // namespace candela

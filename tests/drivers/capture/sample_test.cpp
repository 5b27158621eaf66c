// Captures of samples of scenes, which are compiled and run.
#include <catch2/catch.hpp>
#include <filesystem>

#include "tests/drivers/capture/reproducer.h"

namespace candela {
namespace {

using Catch::Contains;

constexpr const char* kCornell = CANDELA_SOURCE_DIR "/scenes/cornell.p3f";

// Every square root becomes its inverse. A place among the instructions would move whenever a kernel changes.
constexpr const char* kFaultyRoots = "12/31:all:32";

std::vector<std::string> cornell(std::vector<std::string> more) {
  std::vector<std::string> words{kCornell, "--size", "64x64", "--pixel", "20,40", "--sample", "3"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

}  // namespace

TEST_CASE("capture: one dispatch of a path kernel gives the reference's values, and those of the device's own") {
  const TemporaryFolder folder;
  CHECK_THAT(captureTo(folder.path("mega"), cornell({})).out, Contains("computes the expected values"));
  compileReproducer(folder.path("mega"));
  const ProgramResult run = runIn(folder.path("mega"));
  INFO(run.out);
  CHECK(run.exitCode == 0);
  const std::string header = readText(folder.path("mega/capture.h"));
  CHECK_THAT(header, Contains("module_0.spv"));
  CHECK_THAT(header, !Contains("module_1.spv"));
  CHECK_THAT(header, Contains(".groups = {1, 1, 1}"));
}

TEST_CASE("capture: the expected sums have the scale of the film", "[swiftshader-slow]") {
  const TemporaryFolder folder;
  CHECK_THAT(captureTo(folder.path("scaled"), cornell({"--film-scale", "6"})).out,
             Contains("computes the expected values"));
  compileReproducer(folder.path("scaled"));
  CHECK(runIn(folder.path("scaled")).exitCode == 0);
}

TEST_CASE("capture: a wavefront is captured with all its dispatches", "[swiftshader-slow]") {
  const TemporaryFolder folder;
  captureTo(folder.path("wave"), cornell({"--kernel", "wavefront", "--max-depth", "3"}));
  compileReproducer(folder.path("wave"));
  CHECK(runIn(folder.path("wave")).exitCode == 0);
  CHECK_THAT(readText(folder.path("wave/capture.h")), Contains("COMMAND_DISPATCH_INDIRECT"));
}

TEST_CASE("capture: a planted fault shrinks to few statements and short paths", "[swiftshader-slow]") {
  const TemporaryFolder folder;
  const std::vector<std::string> faulty = miscompiled(kFaultyRoots);
  const ProgramResult result = captureTo(folder.path("new"), cornell({"--shrink-time", "60s"}), faulty);
  CHECK_THAT(result.out, Contains("1 x 1 pixels from 20,40 in workgroups of 1 x 1"));
  CHECK_THAT(result.out, Contains("computes other values: "));
  CHECK_THAT(result.out, !Contains("with 19 of 19 statements"));
  const std::string scene = readText(folder.path("new/scene.p3f"));
  CHECK(scene.size() < readText(kCornell).size());
  CHECK(runCandela({"check", folder.path("new/scene.p3f")}).exitCode == 0);
  compileReproducer(folder.path("new"));
  CHECK(runIn(folder.path("new"), faulty).exitCode == 1);
  CHECK(runIn(folder.path("new")).exitCode == 0);
}

TEST_CASE("capture: with --shrink-time 0s the scene stays as it is", "[swiftshader-slow]") {
  const TemporaryFolder folder;
  const ProgramResult result = captureTo(folder.path("new"), cornell({"--shrink-time", "0s"}),
                                         miscompiled(kFaultyRoots));
  CHECK_THAT(result.out, Contains("computes other values: "));
  CHECK_THAT(result.out, Contains("with 19 of 19 statements"));
}

TEST_CASE("capture: a picture of conformance is captured", "[swiftshader-slow]") {
  const TemporaryFolder folder;
  captureTo(folder.path("new"), {"kernel.megakernel.layout.cwbvh.texel.cornell"});
  compileReproducer(folder.path("new"));
  CHECK(runIn(folder.path("new")).exitCode == 0);
}

TEST_CASE("capture: Ctrl-C leaves nothing behind") {
  const TemporaryFolder folder;
  std::vector<std::string> words = cornell({"-o", folder.path("new")});
  words.insert(words.begin(), "capture");
  const ProgramResult result = runCandela(words, {.interruptAfter = std::chrono::milliseconds(400)});
  CHECK(result.exitCode == 7);
  CHECK_THAT(result.err, Contains("interrupted; nothing was written"));
  CHECK(folder.fileCount() == 0);
}

}  // namespace candela

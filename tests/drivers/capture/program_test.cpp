// Command lines that `candela capture` refuses before it opens a device.
#include <catch2/catch.hpp>

#include "tests/app/cli/run_program.h"

namespace candela {
namespace {

using Catch::Contains;

}  // namespace

TEST_CASE("capture refuses what it cannot capture, and says what to do instead") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string output = folder.path("new");
  struct Refusal {
    std::vector<std::string> words;
    int exitCode;
    const char* message;
  };
  for (const Refusal& refusal : std::vector<Refusal>{
           {{}, 1, "no scene or case given"},
           {{scene, "--pixel", "1,1"}, 1, "no output given: name a new folder with -o FOLDER"},
           {{scene, "-o", output}, 1, "--pixel X,Y is missing"},
           {{scene, "-o", output, "--pixel", "16,0"}, 1, "outside the image of 16x12 pixels"},
           {{scene, "-o", output, "--pixel", "1"}, 1, "--pixel: expected X,Y"},
           {{scene, "-o", output, "--pixel", "1,1", "--sample", "16"}, 1, "a pixel has 16 samples (0 to 15)"},
           {{scene, "-o", output, "--pixel", "1,1", "--device", "cpu"}, 1, "choose a Vulkan device"},
           {{scene, "-o", output, "--pixel", "1,1", "--shrink-time", "soon"}, 1, "--shrink-time"},
           {{"control.loop.iteration", "-o", output}, 1, "did you mean control.loop.iterations?"},
           {{"control.loop.iterations", "-o", output, "--spp", "4"}, 1, "--spp does not apply to the case"},
           {{"nothing.p3f", "-o", output}, 1, "there is no such scene file"},
           {{folder.path("nothing.p3f"), "-o", output, "--pixel", "1,1"}, 2, "nothing.p3f"},
           {{scene, "-o", scene, "--pixel", "1,1"}, 2, "is a file"},
           {{"control.loop.iterations", "-o", folder.path("")}, 2, "the folder has files"},
           {{"control.loop.iterations", "-o", "/nonexistent/new"}, 2, "there is no folder /nonexistent"},
           {{"control.loop.iterations", "-o", output, "--device", "nosuch"}, 4, "nosuch"},
           {{scene, "-o", output, "--pixel", "1,1", "--device", "nosuch"}, 4, "nosuch"}}) {
    std::vector<std::string> words{"capture"};
    words.insert(words.end(), refusal.words.begin(), refusal.words.end());
    const ProgramResult result = runCandela(words, withDrivers());
    CAPTURE(refusal.words);
    CHECK(result.exitCode == refusal.exitCode);
    CHECK_THAT(result.err, Contains(refusal.message));
    CHECK(result.out.empty());
  }
  CHECK(folder.fileCount() == 1);
}

TEST_CASE("conformance --capture refuses a folder with files before any case runs") {
  const TemporaryFolder folder;
  folder.write("a", "a");
  const ProgramResult result = runCandela(
      {"conformance", "--cases", "leaf.integer.shift", "--capture", folder.path("")});
  CHECK(result.exitCode == 2);
  CHECK_THAT(result.err, Contains("the folder has files"));
}

}  // namespace candela

// `candela generate` as a user runs it: files, pipes, errors and Ctrl-C.
#include <catch2/catch.hpp>

#include "host/formats/load_scene.h"
#include "tests/app/cli/run_program.h"

namespace candela {
TEST_CASE("a scene is written to the file of -o, or to stdout") {
  const TemporaryFolder folder;
  const ProgramResult toFile = runCandela({"generate", "balls", "--size", "2", "-o", folder.path("balls.nff")});
  CHECK(toFile.exitCode == 0);
  CHECK(toFile.out.empty());
  CHECK(contains(toFile.err, "balls of size 2: 93 primitives"));
  const std::string text = readText(folder.path("balls.nff"));
  CHECK(formats::loadScene(folder.path("balls.nff")).scene.primitives.size() == 93);

  for (const auto& words :
       {std::vector<std::string>{"generate", "balls", "--size", "2"}, {"generate", "balls", "--size=2", "-o", "-"}}) {
    const ProgramResult toStdout = runCandela(words);
    CHECK(toStdout.exitCode == 0);
    CHECK(toStdout.out == text);
  }
  CHECK(folder.fileCount() == 1);
}

TEST_CASE("a kind of scene without a size has its default") {
  const ProgramResult result = runCandela({"generate", "tetra"});
  CHECK(contains(result.err, "tetra of size 6: 4096 primitives"));
  CHECK(result.out == runCandela({"generate", "tetra", "--size", "6"}).out);
}

TEST_CASE("generate --quiet prints nothing but the scene") {
  const ProgramResult result = runCandela({"generate", "jacks", "-q"});
  CHECK(result.err.empty());
  CHECK_FALSE(result.out.empty());
}

TEST_CASE("an unknown kind is refused with the most similar kind, or with all kinds") {
  const ProgramResult near = runCandela({"generate", "mout"});
  CHECK(near.exitCode == 1);
  CHECK(near.err == "candela: unknown kind mout; did you mean mount?\ncandela: see candela generate --help\n");
  const ProgramResult far = runCandela({"generate", "cathedral"});
  CHECK(far.exitCode == 1);
  CHECK(contains(far.err, "unknown kind cathedral; expected balls, mount, "));
  CHECK(contains(far.err, " or floodlights\n"));
}

TEST_CASE("a scene is not written under the name of another format") {
  const TemporaryFolder folder;
  const ProgramResult nff = runCandela({"generate", "cornell", "-o", folder.path("c.gltf")});
  CHECK(nff.exitCode == 1);
  CHECK(contains(nff.err, "cornell is written as NFF; name it " + folder.path("c.nff")));
  CHECK(contains(runCandela({"generate", "still-life", "-o", folder.path("s.glb")}).err, "s.gltf\n"));
  const std::string scene = folder.write("a.p3f", smallScene());
  CHECK(contains(runCandela({"boxes", scene, "-o", folder.path("b.png")}).err, "b.nff\n"));
  CHECK(folder.fileCount() == 1);
}

TEST_CASE("a size out of the kind's range is refused with the range and the reason") {
  const TemporaryFolder folder;
  for (const char* size : {"0", "8", "4294967295"}) {
    const ProgramResult result = runCandela({"generate", "balls", "--size", size, "-o", folder.path("balls.nff")});
    CHECK(result.exitCode == 1);
    CHECK(contains(result.err, "--size: expected a whole number from 1 to 7 for balls, got " + std::string(size)));
    CHECK(contains(result.err, "6000000 primitives"));
  }
  CHECK(runCandela({"generate", "terrain", "--size", "1"}).exitCode == 1);
  const ProgramResult trees = runCandela({"generate", "forest", "--size", "50001"});
  CHECK(trees.exitCode == 1);
  CHECK(contains(trees.err, "expected a whole number from 1 to 50000 for forest, got 50001\n"));
  CHECK(folder.fileCount() == 0);
}

TEST_CASE("a scene that cannot be written is an error and leaves no file") {
  const TemporaryFolder folder;
  CHECK(runCandela({"generate", "tetra", "-o", folder.path("none/tetra.nff")}).exitCode == 2);
  const ProgramResult onFolder = runCandela({"generate", "tetra", "-o", folder.path("")});
  CHECK(onFolder.exitCode == 2);
  CHECK(contains(onFolder.err, "is a folder"));
  const ProgramResult onFullDisk = runCandela({"generate", "tetra", "-o", "/dev/full"});
  CHECK(onFullDisk.exitCode == 2);
  CHECK(contains(onFullDisk.err, "No space left on device"));
  CHECK(runCandela({"generate", "tetra"}, {{}, "/dev/full", {}}).exitCode == 2);
  CHECK(folder.fileCount() == 0);
}

TEST_CASE("Ctrl-C leaves the old file unchanged and no partial new file") {
  const TemporaryFolder folder;
  const std::string file = folder.write("lattice.nff", "old");
  Surroundings interrupted;
  interrupted.interruptAfter = std::chrono::milliseconds(400);
  const ProgramResult result = runCandela({"generate", "lattice", "--size", "113", "-o", file}, interrupted);
  CHECK(result.exitCode == 7);
  CHECK(contains(result.err, "interrupted"));
  CHECK(readText(file) == "old");
  CHECK(folder.fileCount() == 1);
}

}  // namespace candela

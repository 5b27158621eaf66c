// Sequences of frames as a user renders them, on the reference tracer.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <filesystem>

#include "host/job/film/film_lock.h"
#include "tests/app/cli/film_runs.h"
#include "tests/app/cli/sequence_runs.h"

namespace candela {
namespace {

using Catch::Contains;

std::string refusal(const std::vector<std::string>& options, int code) {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.gltf", movingTriangle());
  const ProgramResult result = kReferenceFrames.run(scene, options);
  CHECK(result.exitCode == code);
  return result.err;
}

}  // namespace

TEST_CASE("each frame of a sequence has the bytes of a single render") {
  requireFramesOfSingleRenders(kReferenceFrames);
}

TEST_CASE("a sequence is resumed from its films") { requireResumption(kReferenceFrames); }

TEST_CASE("a sequence without films is resumed from its pictures, if they are its own") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.gltf", movingTriangle());
  const std::string png = folder.path("f#.png"), exr = folder.path("f#.exr");
  const std::vector<std::string> options{"--frames", "0:4", "--fps", "4", "-o", png, "-o", exr, "--resume", png};
  CHECK(kReferenceFrames.run(scene, options).exitCode == 0);
  const std::string second = readText(folder.path("f1.exr"));
  std::filesystem::remove(folder / "f1.exr");
  CHECK_THAT(kReferenceFrames.run(scene, options).err, Contains("4 frames, of which 3 existed"));
  CHECK(readText(folder.path("f1.exr")) == second);

  std::vector<std::string> others = options;
  others.insert(others.end(), {"--spp", "5"});
  const ProgramResult differs = kReferenceFrames.run(scene, others);
  CHECK(differs.exitCode == 2);
  CHECK_THAT(differs.err,
             Contains("f0.exr: the picture is not of this sequence: its candela.samplesPerPixel is 4, and that "
                      "of the frame 5"));
  others.back() = "4";
  others.insert(others.end(), {"--size", "25x18"});
  CHECK_THAT(kReferenceFrames.run(scene, others).err,
             Contains("f0.png: the picture is not of this sequence: it has 24x18"));
}

TEST_CASE("films of another render are not continued, and none is overwritten") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.gltf", movingTriangle());
  const std::string films = folder.path("f#.exr");
  const std::vector<std::string> options{"--frames", "0:2", "--checkpoint", films};
  REQUIRE(kReferenceFrames.run(scene, {"--frames", "1:2", "--checkpoint", films}).exitCode == 0);
  const ProgramResult begun = kReferenceFrames.run(scene, options);
  CHECK(begun.exitCode == 2);
  CHECK_THAT(begun.err, Contains("f1.exr: the file exists, and its samples would be lost; continue the sequence with "
                                 "--resume '" +
                                 films + "'"));
  CHECK_FALSE(std::filesystem::exists(folder / "f0.exr"));
  std::vector<std::string> others = options;
  others.insert(others.end(), {"--resume", films, "--seed", "3"});
  const ProgramResult differs = kReferenceFrames.run(scene, others);
  CHECK(differs.exitCode == 2);
  CHECK_THAT(differs.err, Contains("use --seed 0") && Contains("frame 1 failed"));
  CHECK(std::filesystem::exists(folder / "f0.exr"));
}

TEST_CASE("an interrupted sequence continues, and leaves no picture of fewer samples") {
  const TemporaryFolder whole, folder;
  const std::string scene = whole.write("a.gltf", movingTriangle());
  const std::vector<std::string> options{"--frames", "0:30", "--size", "96x72", "--spp", "16", "--threads", "1"};
  const auto sequence = [&](const TemporaryFolder& to, const Surroundings& surroundings) {
    std::vector<std::string> words = options;
    words.insert(words.end(),
                 {"-o", to.path("f##.png"), "--checkpoint", to.path("film##.exr"), "--resume", to.path("film##.exr")});
    return kReferenceFrames.run(scene, words, surroundings);
  };
  REQUIRE(sequence(whole, {}).exitCode == 0);
  const ProgramResult stopped = sequence(folder, {.interruptAfter = std::chrono::milliseconds(300)});
  CHECK(stopped.exitCode == 7);
  CHECK_THAT(stopped.err, Contains("the sequence ends before frame") && Contains("the same command with --resume"));
  REQUIRE(sequence(folder, {}).exitCode == 0);
  for (int frame = 0; frame < 30; ++frame) {
    const std::string number = fmt::format("{:02}", frame);
    INFO(number);
    CHECK(readText(folder.path("f" + number + ".png")) == readText(whole.path("f" + number + ".png")));
    CHECK(readText(folder.path("film" + number + ".exr")) == readText(whole.path("film" + number + ".exr")));
  }
}

TEST_CASE("two processes may render different frames of one sequence, but not the same ones") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.gltf", movingTriangle());
  const std::string pictures = folder.path("f##.png");
  const film::FilmLock other(pictures, {0, 5});
  const ProgramResult same = kReferenceFrames.run(scene, {"--frames", "4:6", "-o", pictures});
  CHECK(same.exitCode == 2);
  CHECK_THAT(same.err, Contains("f##.png: another render is writing some of these frames"));
  CHECK(kReferenceFrames.run(scene, {"--frames", "5:6", "-o", pictures}).exitCode == 0);
}

TEST_CASE("a full disk in the middle ends a sequence, and the frames before it stay") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.gltf", movingTriangle());
  // Frames are PFM files of 24 x 18 x 12 bytes and more, and the third has no folder to be written to.
  std::filesystem::create_directory(folder / "f2.pfm");
  const ProgramResult result = kReferenceFrames.run(scene, {"--frames", "0:4", "-o", folder.path("f#.pfm")});
  CHECK(result.exitCode == 2);
  CHECK_THAT(result.err, Contains("f2.pfm: is a folder") && Contains("frame 2 failed"));
  CHECK(std::filesystem::exists(folder / "f1.pfm"));
  CHECK_FALSE(std::filesystem::exists(folder / "f3.pfm"));
}

TEST_CASE("sequences that make no sense are refused with the reason") {
  CHECK_THAT(refusal({"--frames", "5:5", "-o", "f#.png"}, 1), Contains("--frames: expected A:B with A below B"));
  CHECK_THAT(refusal({"--frames", "0:5", "-o", "f.png"}, 1),
             Contains("-o f.png: the name lacks a place for the number of the frame, as in frame.####.png"));
  CHECK_THAT(refusal({"--frames", "0:5", "-o", "-"}, 1), Contains("-o -: the name lacks a place"));
  CHECK_THAT(refusal({"--frames", "0:5", "-o", "f#.png", "--checkpoint", "film.exr"}, 1),
             Contains("--checkpoint film.exr: the name lacks a place"));
  CHECK_THAT(refusal({"--frames", "0:5", "-o", "f#.png", "--time", "2"}, 1),
             Contains("--time and --frames both state the time of a frame"));
  CHECK_THAT(refusal({"--fps", "5", "-o", "f.png"}, 1), Contains("--fps has no effect without --frames"));
  CHECK_THAT(refusal({"--seed", "frame", "-o", "f.png"}, 1), Contains("--seed frame needs --frames"));
  CHECK_THAT(refusal({"--frames", "0:2", "-o", "f#.png", "--checkpoint", "f#.png"}, 1), Contains("f#.png"));
}

TEST_CASE("frames beyond the animation hold its last pose, with a note") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.gltf", movingTriangle());
  const ProgramResult result = kReferenceFrames.run(
      scene, {"--frames", "0:4", "--fps", "1", "--seed", "1", "-o", folder.path("f#.png")});
  CHECK(result.exitCode == 0);
  CHECK_THAT(result.err, Contains("the animation ends at 1 s; later frames show its last pose"));
  CHECK_THAT(result.err, Contains("4 frames, ") && Contains(" s on cpu\n"));
  CHECK(readText(folder.path("f1.png")) == readText(folder.path("f3.png")));
  CHECK(readText(folder.path("f1.png")) != readText(folder.path("f0.png")));
  const std::string still = folder.write("a.p3f", smallScene());
  CHECK_THAT(kReferenceFrames.run(still, {"--frames", "0:2", "-o", folder.path("s#.png")}).err,
             Contains("--turntable N turns the camera about a scene without an animation"));
}

TEST_CASE("reports of frames are files of their own") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.gltf", movingTriangle());
  REQUIRE(kReferenceFrames.run(scene, {"--frames", "0:2", "--fps", "2", "--json", folder.path("r#.json")}).exitCode ==
          0);
  CHECK(jsonOf(folder.path("r1.json"))["settings"]["time"] == 0.5);
}

}  // namespace candela

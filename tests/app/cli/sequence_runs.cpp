// Renders sequences and single images with equal options, and compares their files.
#include "tests/app/cli/sequence_runs.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

namespace candela {
namespace {

std::vector<std::string> joined(std::vector<std::string> words, const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

std::map<std::string, std::string> filesOf(const std::filesystem::path& folder, const std::string& extension) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == extension) files[entry.path().filename()] = readText(entry.path());
  }
  return files;
}

/// Renders one image with these options and compares its picture and its film with those of a frame.
void requireFrame(const SequenceRuns& runs, const std::string& scene, const TemporaryFolder& folder,
                  const std::string& frame, const std::vector<std::string>& options) {
  INFO("frame " << frame);
  const TemporaryFolder single;
  const ProgramResult result = runs.run(scene, joined(options, {"-o", single.path("a.png"), "-o", single.path("a.exr"),
                                                                "--checkpoint", single.path("film.exr")}));
  INFO(result.err);
  REQUIRE(result.exitCode == 0);
  CHECK(readText(folder.path("f" + frame + ".png")) == readText(single.path("a.png")));
  CHECK(readText(folder.path("p" + frame + ".exr")) == readText(single.path("a.exr")));
  CHECK(readText(folder.path("film" + frame + ".exr")) == readText(single.path("film.exr")));
}

std::vector<std::string> filesIn(const TemporaryFolder& folder) {
  return {"-o", folder.path("f###.png"), "-o", folder.path("p###.exr"), "--checkpoint", folder.path("film###.exr")};
}

void requireSequence(const SequenceRuns& runs, const std::string& scene, const TemporaryFolder& folder,
                     const std::vector<std::string>& options) {
  const ProgramResult result = runs.run(scene, joined(options, filesIn(folder)));
  INFO(result.err);
  REQUIRE(result.exitCode == 0);
}

}  // namespace

std::string movingTriangle() { return readText(CANDELA_SOURCE_DIR "/tests/farm/moving_triangle.gltf"); }

ProgramResult SequenceRuns::run(const std::string& scene, const std::vector<std::string>& options,
                                const Surroundings& surroundings) const {
  return runCandela(joined(joined({scene}, common), options), surroundings);
}

void requireFramesOfSingleRenders(const SequenceRuns& runs) {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.gltf", movingTriangle());
  requireSequence(runs, scene, folder, {"--frames", "8:11", "--fps", "30", "--seed", "7"});
  // 8 / 30, 9 / 30 and 10 / 30, as any program prints them.
  requireFrame(runs, scene, folder, "008", {"--time", "0.26666666666666666", "--seed", "7"});
  requireFrame(runs, scene, folder, "009", {"--time", "0.3", "--seed", "7"});
  requireFrame(runs, scene, folder, "010", {"--time", "0.3333333333333333", "--seed", "7"});

  const TemporaryFolder turn;
  requireSequence(runs, scene, turn, {"--turntable", "3", "--seed", "frame"});
  requireFrame(runs, scene, turn, "000", {"--orbit", "0", "--seed", "0"});
  requireFrame(runs, scene, turn, "001", {"--orbit", "120", "--seed", "1"});
  requireFrame(runs, scene, turn, "002", {"--orbit", "240", "--seed", "2"});

  const TemporaryFolder both;
  requireSequence(runs, scene, both, {"--turntable", "4", "--fps", "4", "--frames", "1:6", "--orbit", "-90"});
  requireFrame(runs, scene, both, "001", {"--orbit", "0", "--time", "0.25"});
  requireFrame(runs, scene, both, "005", {"--orbit", "0", "--time", "1.25"});
}

void requireResumption(const SequenceRuns& runs) {
  const TemporaryFolder whole, part;
  const std::string scene = whole.write("a.gltf", movingTriangle());
  const std::vector<std::string> options{"--frames", "0:5", "--fps", "5"};
  requireSequence(runs, scene, whole, options);
  requireSequence(runs, scene, part, options);
  std::filesystem::remove(part / "f001.png");
  std::filesystem::remove(part / "film002.exr");
  std::filesystem::remove(part / "film003.exr");
  std::filesystem::remove(part / "p003.exr");
  const ProgramResult begun = runs.run(scene,
                                       {"--time", "0.8", "--samples", "0:2", "--checkpoint", part.path("film.exr")});
  REQUIRE(begun.exitCode == 0);
  std::filesystem::rename(part / "film.exr", part / "film004.exr");
  const auto first = std::filesystem::last_write_time(part / "f000.png");

  const ProgramResult result = runs.run(scene,
                                        joined(joined(options, filesIn(part)), {"--resume", part.path("film###.exr")}));
  INFO(result.err);
  CHECK(result.exitCode == 0);
  CHECK_THAT(result.err, Catch::Contains("5 frames, of which 1 existed"));
  CHECK(std::filesystem::last_write_time(part / "f000.png") == first);
  for (const char* extension : {".png", ".exr"})
    CHECK(filesOf(part.path(""), extension) == filesOf(whole.path(""), extension));
}

}  // namespace candela

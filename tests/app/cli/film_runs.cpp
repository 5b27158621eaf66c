// Divides, stops and kills renders, and compares the films that they end with.
#include "tests/app/cli/film_runs.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <random>

namespace candela {
namespace {

using std::chrono::milliseconds;

// For words "--name value", the program uses the last one of each name, but all outputs.
std::vector<std::string> joined(const std::string& scene, std::vector<std::string> words,
                                const std::vector<std::string>& more) {
  words.insert(words.begin(), scene);
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

std::vector<std::string> with(std::vector<std::string> words, const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

struct Shard {
  std::string samples, crop;
};

// The shards of a division, rendered and merged in order and in reverse.
void requireMerged(const FilmRuns& runs, const TemporaryFolder& folder, const std::string& scene,
                   const std::vector<std::string>& options, const std::vector<Shard>& shards,
                   const std::string& whole) {
  std::vector<std::string> files;
  for (const auto& [samples, crop] : shards) {
    files.push_back(folder.path("shard" + std::to_string(files.size()) + ".exr"));
    std::filesystem::remove(files.back());
    runs.film(scene, files.back(), with(options, {"--samples", samples, "--crop", crop}));
  }
  for (int order = 0; order < 2; ++order) {
    const std::string merged = folder.path("merged.exr");
    const ProgramResult result = runCandela(with(with({"merge"}, files), {"-o", merged}));
    INFO(result.err);
    REQUIRE(result.exitCode == 0);
    CHECK(readText(merged) == whole);
    std::ranges::reverse(files);
  }
}

milliseconds durationOf(const FilmRuns& runs, const std::string& scene, const std::string& file, std::string& bytes) {
  const auto start = std::chrono::steady_clock::now();
  bytes = runs.film(scene, file);
  return std::chrono::duration_cast<milliseconds>(std::chrono::steady_clock::now() - start);
}

// One run, killed after `time`, and the run that resumes it.
void requireSurvivesKill(const FilmRuns& runs, const TemporaryFolder& folder, const std::string& scene,
                         milliseconds time, const std::string& whole) {
  const std::string film = folder.path("killed.exr");
  std::filesystem::remove(film);
  std::filesystem::remove(film + ".json");
  const std::size_t filesBefore = folder.fileCount();
  Surroundings surroundings;
  surroundings.interruptAfter = time;
  surroundings.signal = SIGKILL;
  surroundings.writeRequestsEvery = milliseconds(15);
  runs.run(scene, {"--checkpoint", film}, surroundings);
  INFO("killed after " << time.count() << " ms");
  CHECK(folder.fileCount() <= filesBefore + 4);  // film, report, lock, and the temporary file of a write
  const bool exists = std::filesystem::exists(film);
  if (exists) {
    const ProgramResult description = runCandela({"film", film});
    INFO(description.err);
    REQUIRE(description.exitCode == 0);
  }
  CHECK(runs.film(scene, film, exists ? std::vector<std::string>{"--resume", film} : std::vector<std::string>{}) ==
        whole);
  CHECK(folder.fileCount() == filesBefore + 2);
}

}  // namespace

ProgramResult FilmRuns::run(const std::string& scene, const std::vector<std::string>& options,
                            const Surroundings& surroundings) const {
  return runCandela(joined(scene, common, options), surroundings);
}

std::string FilmRuns::film(const std::string& scene, const std::string& file,
                           const std::vector<std::string>& options) const {
  const ProgramResult result = run(scene, with(options, {"--checkpoint", file}));
  INFO(result.err);
  REQUIRE(result.exitCode == 0);
  return readText(file);
}

std::string FilmRuns::refusal(const std::string& scene, const std::vector<std::string>& options) const {
  const ProgramResult result = run(scene, with(options, {"--stats"}));
  INFO(result.err);
  CHECK(result.exitCode == 2);
  CHECK(result.out.empty());
  return result.err;
}

void requireEqualDivisions(const FilmRuns& runs, const TemporaryFolder& folder,
                           const std::vector<std::string>& options) {
  const std::string scene = folder.write("scene.p3f", smallScene());
  const std::string whole = runs.film(scene, folder.path("whole.exr"), options);
  const bool sixteen = std::ranges::find(options, "16") != options.end();
  const std::string end = sixteen ? "16" : "12";
  requireMerged(runs, folder, scene, options, {{"0:5", "0,0,48,36"}, {"5:6", "0,0,48,36"}, {"6:" + end, "0,0,48,36"}},
                whole);
  requireMerged(runs, folder, scene, options, {{"0:" + end, "0,0,19,36"}, {"0:" + end, "19,0,29,36"}}, whole);
  requireMerged(
      runs, folder, scene, options,
      {{"0:3", "0,0,48,17"}, {"3:" + end, "0,0,20,17"}, {"3:" + end, "20,0,28,17"}, {"0:" + end, "0,17,48,19"}}, whole);
  const std::string film = folder.path("resumed.exr");
  runs.film(scene, film, with(options, {"--samples", "0:4"}));
  runs.film(scene, film, with(options, {"--samples", "0:7", "--resume", film}));
  CHECK(runs.film(scene, film, with(options, {"--resume", film})) == whole);
}

void requireSurvivesKills(const FilmRuns& runs, int even, int random) {
  const TemporaryFolder folder;
  const std::string scene = folder.write("scene.p3f", smallScene());
  std::string whole;
  const milliseconds duration = durationOf(runs, scene, folder.path("whole.exr"), whole);
  for (int i = 0; i < even; ++i) {
    requireSurvivesKill(runs, folder, scene, duration * (2 * i + 1) / (2 * even), whole);
  }
  std::mt19937 numbers(1);
  for (int i = 0; i < random; ++i) {
    const auto time = static_cast<milliseconds::rep>(numbers() % static_cast<std::uint32_t>(duration.count()));
    requireSurvivesKill(runs, folder, scene, milliseconds(time), whole);
  }
}

}  // namespace candela

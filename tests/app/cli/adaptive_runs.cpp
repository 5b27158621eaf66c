// Stops renders after increasing fractions of the time that they take.
#include "tests/app/cli/adaptive_runs.h"

#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>

namespace candela {
namespace {

using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

// Renders until the film is complete, which takes about `duration` without stops, and stops each run after a part of
// this time. Returns the number of runs that were stopped.
int renderWithStops(const FilmRuns& runs, const std::string& scene, const std::string& film, int stops,
                    milliseconds duration) {
  int stopped = 0;
  for (int i = 0; i < stops; ++i) {
    std::vector<std::string> options{"--checkpoint", film, "--checkpoint-every", "0.02s"};
    if (i > 0) options.insert(options.end(), {"--resume", film});
    Surroundings surroundings;
    surroundings.interruptAfter = duration * (2 + i) / 10;
    surroundings.signal = SIGINT;
    const int code = runs.run(scene, options, surroundings).exitCode;
    CAPTURE(i, duration.count(), code);
    REQUIRE((code == 0 || code == 7));
    if (code == 0) return stopped;
    ++stopped;
  }
  return stopped;
}

}  // namespace

void requireEqualAdaptiveFilms(const FilmRuns& runs, const TemporaryFolder& folder, int stops) {
  const std::string scene = folder.write("scene.p3f", causticScene());
  const Clock::time_point start = Clock::now();
  const std::string whole = runs.film(scene, folder.path("whole.exr"));
  const auto duration = std::chrono::duration_cast<milliseconds>(Clock::now() - start);
  const std::string left = folder.path("left.exr");
  const std::string right = folder.path("right.exr");
  runs.film(scene, left, {"--crop", "0,0,64,68"});
  runs.film(scene, right, {"--crop", "64,0,8,68"});
  const std::string merged = folder.path("merged.exr");
  REQUIRE(runCandela({"merge", right, left, "-o", merged}).exitCode == 0);
  CHECK(readText(merged) == whole);
  const std::string film = folder.path("stopped.exr");
  const int stopped = renderWithStops(runs, scene, film, stops, duration);
  INFO(stopped << " stops");
  CHECK(stopped > 0);
  CHECK(runs.film(scene, film, {"--resume", film}) == whole);
}

}  // namespace candela

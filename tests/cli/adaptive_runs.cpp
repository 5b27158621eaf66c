// Stops renders after increasing times.
#include "tests/cli/adaptive_runs.h"

#include <catch2/catch.hpp>
#include <filesystem>

namespace candela {
namespace {

using std::chrono::milliseconds;

// Renders until the film is complete, and stops each run after a time. Returns the number of runs that were stopped.
int renderWithStops(const FilmRuns& runs, const std::string& scene, const std::string& film, int stops) {
  int stopped = 0;
  for (int i = 0; i < stops; ++i) {
    std::vector<std::string> options{"--checkpoint", film, "--checkpoint-every", "0.02s"};
    if (i > 0) options.insert(options.end(), {"--resume", film});
    Surroundings surroundings;
    surroundings.interruptAfter = milliseconds(60 + 30 * i);
    surroundings.signal = SIGINT;
    const int code = runs.run(scene, options, surroundings).exitCode;
    REQUIRE((code == 0 || code == 7));
    if (code == 0) return stopped;
    ++stopped;
  }
  return stopped;
}

}  // namespace

void requireEqualAdaptiveFilms(const FilmRuns& runs, const TemporaryFolder& folder, int stops) {
  const std::string scene = folder.write("scene.p3f", causticScene());
  const std::string whole = runs.film(scene, folder.path("whole.exr"));
  const std::string left = folder.path("left.exr");
  const std::string right = folder.path("right.exr");
  runs.film(scene, left, {"--crop", "0,0,64,68"});
  runs.film(scene, right, {"--crop", "64,0,8,68"});
  const std::string merged = folder.path("merged.exr");
  REQUIRE(runCandela({"merge", right, left, "-o", merged}).exitCode == 0);
  CHECK(readText(merged) == whole);
  const std::string film = folder.path("stopped.exr");
  const int stopped = renderWithStops(runs, scene, film, stops);
  INFO(stopped << " stops");
  CHECK(stopped > 0);
  CHECK(runs.film(scene, film, {"--resume", film}) == whole);
}

}  // namespace candela

// Films of a Vulkan device: divided, killed and resumed, with the bytes of one run.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "tests/app/cli/film_runs.h"

namespace candela {
namespace {

FilmRuns onDevice(std::vector<std::string> options) {
  if (const char* device = std::getenv("CANDELA_TEST_DEVICE")) options.insert(options.end(), {"--device", device});
  return {std::move(options)};
}

const std::vector<std::string> kSmall{"--size", "48x36", "--spp", "12", "--max-depth", "6"};

}  // namespace

TEST_CASE("a device's film has the same bytes however it was divided", "[swiftshader-slow]") {
  const TemporaryFolder folder;
  requireEqualDivisions(onDevice(kSmall), folder, {});
}

TEST_CASE("a device's film with alpha has the same bytes however it was divided", "[swiftshader-slow]") {
  const TemporaryFolder folder;
  const FilmRuns runs = onDevice(kSmall);
  requireEqualDivisions(runs, folder, {"--background", "none"});
  const std::string scene = folder.path("scene.p3f");
  CHECK(runs.film(scene, folder.path("wavefront.exr"), {"--background", "none", "--kernel", "wavefront"}) ==
        readText(folder.path("whole.exr")));
}

TEST_CASE("a device's film with layers has the same bytes however it was divided", "[swiftshader-slow]") {
  const TemporaryFolder folder;
  const FilmRuns runs = onDevice(kSmall);
  const std::vector<std::string> layers{"--aov", "normal,depth,uv,direct"};
  requireEqualDivisions(runs, folder, layers);
  std::vector<std::string> options = layers;
  options.insert(options.end(), {"--kernel", "wavefront"});
  CHECK(runs.film(folder.path("scene.p3f"), folder.path("wavefront.exr"), options) ==
        readText(folder.path("whole.exr")));
}

TEST_CASE("the wavefront resumes the megakernel's film, with the same bytes", "[swiftshader-slow]") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const FilmRuns runs = onDevice(kSmall);
  const std::string whole = runs.film(scene, folder.path("whole.exr"));
  const std::string film = folder.path("a.exr");
  runs.film(scene, film, {"--samples", "0:5"});
  CHECK(runs.film(scene, film, {"--resume", film, "--kernel", "wavefront"}) == whole);
}

TEST_CASE("a film of a device is not resumed or merged with the reference, unless requested", "[swiftshader-slow]") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const FilmRuns runs = onDevice(kSmall);
  const std::string a = folder.path("a.exr");
  const std::string b = folder.path("b.exr");
  runs.film(scene, a, {"--samples", "0:5"});
  const FilmRuns reference{kSmall};
  CHECK_THAT(reference.refusal(scene, {"--device", "cpu", "--resume", a}), Catch::Contains("the device is "));
  reference.film(scene, b, {"--device", "cpu", "--samples", "5:12"});
  const std::string merged = folder.path("merged.exr");
  CHECK_THAT(runCandela({"merge", a, b, "-o", merged}).err, Catch::Contains("--mixed-devices"));
  CHECK(runCandela({"merge", a, b, "-o", merged, "--mixed-devices"}).exitCode == 0);
  const auto description = nlohmann::json::parse(runCandela({"film", merged, "--json", "-"}).out);
  CHECK(description["mixed"] == true);
  CHECK(description["tracers"].size() == 2);
  CHECK(description["complete"] == true);
}

TEST_CASE("a render on a device that is killed resumes from its checkpoint", "[swiftshader-slow]") {
  requireSurvivesKills(onDevice({"--size", "128x96", "--spp", "400", "--max-depth", "6"}), 4, 0);
}

}  // namespace candela

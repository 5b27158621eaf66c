// Adaptively sampled films of a Vulkan device.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "tests/app/cli/adaptive_runs.h"

namespace candela {
namespace {

FilmRuns onAdaptiveDevice() {
  std::vector<std::string> options{"--size", "72x68", "--max-depth", "8"};
  if (const char* device = std::getenv("CANDELA_TEST_DEVICE")) options.insert(options.end(), {"--device", device});
  return {adaptiveOptions(std::move(options))};
}

}  // namespace

TEST_CASE("adaptive: a device's film has the same bytes however it was interrupted, divided into crops and resumed",
          "[swiftshader-slow]") {
  const TemporaryFolder folder;
  requireEqualAdaptiveFilms(onAdaptiveDevice(), folder, 8);
}

TEST_CASE("adaptive: every kernel and every dispatch size gives the same film, with layers and without",
          "[swiftshader-slow]") {
  const TemporaryFolder folder;
  const FilmRuns runs = onAdaptiveDevice();
  const std::string scene = folder.write("a.p3f", causticScene());
  const std::string whole = runs.film(scene, folder.path("a.exr"), {"--aov", "normal,direct"});
  CHECK(runs.film(scene, folder.path("b.exr"), {"--aov", "normal,direct", "--kernel", "wavefront"}) == whole);
  CHECK(runs.film(scene, folder.path("c.exr"), {"--aov", "normal,direct", "--tile", "24x8"}) == whole);
  const auto hashOf = [](const std::string& film) {
    return nlohmann::json::parse(runCandela({"film", film, "--json", "-"}).out)["filmHash"];
  };
  runs.film(scene, folder.path("d.exr"), {"--segments-per-dispatch", "3"});
  CHECK(hashOf(folder.path("d.exr")) == hashOf(folder.path("a.exr")));
}

TEST_CASE("adaptive: stopped pixels cost no rays") {
  const TemporaryFolder folder;
  const FilmRuns runs = onAdaptiveDevice();
  const std::string scene = folder.write("a.p3f", causticScene());
  const ProgramResult result = runs.run(scene, {"-o", folder.path("a.exr"), "--json", "-"});
  REQUIRE(result.exitCode == 0);
  const auto report = nlohmann::json::parse(result.out);
  CHECK(report["rays"]["camera"] == report["samples"]);
  CHECK(report["samples"].get<double>() == Approx(report["adaptive"]["meanSamples"].get<double>() * 72 * 68));
  CHECK(report["samples"] < 72 * 68 * 96 / 2);
}

}  // namespace candela

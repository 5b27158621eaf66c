// Bad samples and --strict as a user sees them, on the reference tracer.
#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "host/image/image.h"
#include "tests/app/cli/run_program.h"

namespace candela {
namespace {

using Catch::Contains;
using nlohmann::json;

// A light brighter than the film can represent, in the middle of 8x8 pixels.
std::string tooBrightScene() {
  return "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 40\nhither 1\nresolution 8 8\n"
         "f 0 0 0 1 0 0 0 0 1 0 1 1e7 1 1\ns 0 0 0 0.5\n";
}

}  // namespace

TEST_CASE("a render with bad samples reports their number, positions and replays, and succeeds") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("bright.p3f", tooBrightScene());
  const std::string exr = folder.path("a.exr");
  const std::string report = folder.path("a.json");
  const ProgramResult result = runCandela(
      {scene, "-o", exr, "--json", report, "--device", "cpu", "--film-scale", "0", "--spp", "4", "--seed", "3", "-q"});
  CHECK(result.exitCode == 0);
  CHECK_THAT(result.err, Contains("samples in") && Contains("the first is sample 0; replay: candela explain ") &&
                             Contains("--seed 3") && Contains("--sample 0"));

  const json statistics = json::parse(readText(report));
  const image::Image image = image::readImage(exr);
  CHECK(image.badSampleCounts[4 * 8 + 4] == 4);
  CHECK(image.badSampleCounts[0] == 0);
  CHECK(statistics["badSamples"]["samples"] == badSampleCount(image));
  const auto badPixels = image.badSampleCounts.size() -
                         static_cast<std::size_t>(
                             std::count(image.badSampleCounts.begin(), image.badSampleCounts.end(), 0u));
  CHECK(statistics["badSamples"]["pixels"] == badPixels);
  REQUIRE(statistics["badSamples"]["firstPixels"].size() == std::min<std::size_t>(badPixels, 5));
  const json& first = statistics["badSamples"]["firstPixels"][0];
  CHECK(first["samples"] == image.badSampleCounts[first["y"].get<std::size_t>() * 8 + first["x"].get<std::size_t>()]);
  CHECK_THAT(result.err, Contains(first["replay"].get<std::string>()));
}

TEST_CASE("the option --strict exits with 3 after bad samples and still writes the files") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("bright.p3f", tooBrightScene());
  const std::string exr = folder.path("a.exr");
  const ProgramResult result = runCandela(
      {scene, "-o", exr, "--device", "cpu", "--film-scale", "0", "--spp", "4", "--strict", "-q"});
  CHECK(result.exitCode == 3);
  CHECK_THAT(result.err, Contains("--strict: ") && Contains("the run fails"));
  CHECK(image::badSampleCount(image::readImage(exr)) > 0);

  // Files remember what they were made of.
  const ProgramResult plain = runCandela({"compare", exr, exr, "--tolerance", "0", "--json", "-"});
  CHECK(plain.exitCode == 0);
  CHECK(json::parse(plain.out)["badSamples"]["b"]["samples"] == image::badSampleCount(image::readImage(exr)));
  CHECK_THAT(plain.err, Contains("the files contain"));
  CHECK(runCandela({"compare", exr, exr, "--tolerance", "0", "--strict"}).exitCode == 3);
}

TEST_CASE("the option --strict changes nothing if no sample is bad") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string exr = folder.path("a.exr");
  const ProgramResult result = runCandela({scene, "-o", exr, "--device", "cpu", "--spp", "2", "--strict", "-q"});
  CHECK(result.exitCode == 0);
  CHECK(result.err.empty());
  CHECK(image::readImage(exr).badSampleCounts.empty());
  CHECK(runCandela({"compare", exr, exr, "--strict", "-q"}).exitCode == 0);
}

}  // namespace candela

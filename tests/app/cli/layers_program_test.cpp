// Layers as a user requests them, and refused requests.
#include <catch2/catch.hpp>

#include "tests/app/cli/run_program.h"

namespace candela {
namespace {

ProgramResult renderLayers(const TemporaryFolder& folder, std::vector<std::string> options) {
  options.insert(options.begin(), {folder.write("a.p3f", smallScene()), "--device", "cpu", "--spp", "1"});
  return runCandela(options);
}

void requireRefusal(const std::vector<std::string>& options, int exitCode, const std::string& message) {
  const TemporaryFolder folder;
  std::vector<std::string> words{"-o", folder.path("a.exr")};
  words.insert(words.end(), options.begin(), options.end());
  const ProgramResult result = renderLayers(folder, words);
  CAPTURE(result.err);
  CHECK(result.exitCode == exitCode);
  CHECK(contains(result.err, message));
  CHECK(folder.fileCount() == 1);
}

}  // namespace

TEST_CASE("unknown layers are refused with the names of all") {
  for (const char* list : {"normals", "normal,", "", "normal depth", "normal,,depth"}) {
    CAPTURE(list);
    requireRefusal({"--aov", list}, 1,
                   "among normal, albedo, depth, position, uv, direct, indirect, emission, variance, samples, moments, "
                   "crypto-object, crypto-material, id, material, all");
  }
}

TEST_CASE("layers are refused without an EXR file or a film file, and by other integrators") {
  const TemporaryFolder folder;
  const ProgramResult noExr = renderLayers(folder, {"--aov", "normal", "-o", folder.path("a.png")});
  CHECK(noExr.exitCode == 1);
  CHECK(contains(noExr.err, "layers are written to EXR and film files only; add -o FILE.exr or --checkpoint FILE"));
  CHECK(renderLayers(folder, {"--aov", "normal"}).exitCode == 1);
  requireRefusal({"--aov", "depth", "--integrator", "whitted"}, 1, "only the path tracer has layers");
  requireRefusal({"--aov", "depth", "--integrator", "normal"}, 1, "only the path tracer has layers");
}

TEST_CASE("values of layers beyond the range are limited, with a warning") {
  const TemporaryFolder folder;
  const std::string scene = folder.write(
      "far.p3f",
      "v\nfrom 0 0 0\nat 0 1 0\nup 0 0 1\nangle 1\nhither 0\nresolution 2 2\nf 1 1 1 1 0 0 0 0 1 0 1 0 0 0\n"
      "p 3\n-9e6 2e6 -9e6\n9e6 2e6 -9e6\n0 2e6 9e6\n");
  const std::vector<std::string> words{scene, "--device", "cpu", "--spp", "1", "-o", folder.path("a.exr"), "--aov"};
  const auto with = [&](const char* layers) {
    std::vector<std::string> all = words;
    all.push_back(layers);
    return runCandela(all);
  };
  CHECK(contains(with("depth").err, "layer values of 4 samples are not finite or above 2^20"));
  CHECK_FALSE(contains(with("normal").err, "values of layers"));
}

TEST_CASE("a PNG file beside the EXR file shows the image as without layers") {
  const TemporaryFolder folder;
  const std::string exr = folder.path("a.exr"), png = folder.path("a.png"), plain = folder.path("b.png");
  REQUIRE(renderLayers(folder, {"--aov", "uv,normal", "-o", exr, "-o", png}).exitCode == 0);
  REQUIRE(renderLayers(folder, {"-o", plain}).exitCode == 0);
  CHECK(readText(png) == readText(plain));
}

}  // namespace candela

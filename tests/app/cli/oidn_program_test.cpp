// --denoise oidn with a substitute for the library, and without the library.
#include <catch2/catch.hpp>

#include "host/image/image.h"
#include "tests/app/cli/run_program.h"

namespace candela {
namespace {

using Catch::Contains;

const Surroundings kStub{.environment = {std::string("LD_LIBRARY_PATH=") + CANDELA_OIDN_STUB}};
const Surroundings kNoLibrary{.environment = {"LD_LIBRARY_PATH=/nonexistent"}};

// A lit wall, which fills the picture.
const std::string kWall =
    "b 0.1 0.1 0.1\nv\nfrom 0 0 2\nat 0 0 0\nup 0 1 0\nangle 40\nhither 0.1\nresolution 6 5\nl 0 0 2\n"
    "f 0.5 0.25 0.75 1 0 0 0 0\np 4\n-9 -9 0\n9 -9 0\n9 9 0\n-9 9 0\n";

ProgramResult renderWall(const TemporaryFolder& folder, std::vector<std::string> options,
                         const Surroundings& surroundings) {
  options.insert(options.begin(), {folder.write("wall.nff", kWall), "--device", "cpu", "--spp", "4"});
  return runCandela(options, surroundings);
}

// The colours of the substitute: half of the light, and the albedo and the normal of the wall.
bool areOfStub(const image::Image& image, const image::Image& plain) {
  for (std::size_t i = 0; i < image.rgb.size(); ++i) {
    const glm::vec3 difference = image.rgb[i] - (plain.rgb[i] / 2.0f + glm::vec3(0.5f, 0.25f, 1.75f));
    if (!(dot(difference, difference) < 1e-10f)) return false;
  }
  return !image.rgb.empty();
}

}  // namespace

TEST_CASE("Open Image Denoise receives the light, the albedo and the normal of each pixel") {
  const TemporaryFolder folder;
  const std::string a = folder.path("a.exr"), b = folder.path("b.exr"), film = folder.path("film.exr");
  const ProgramResult result = renderWall(folder, {"--denoise", "oidn", "-o", a, "--checkpoint", film}, kStub);
  INFO(result.err);
  REQUIRE(result.exitCode == 0);
  const image::Image denoised = image::readImage(a), plain = image::readImage(film);
  CHECK(areOfStub(denoised, plain));
  CHECK(denoised.luminanceVariance.empty());
  CHECK_THAT(denoised.metadata.at("candela.denoised"), Contains("Open Image Denoise"));
  CHECK_THAT(denoised.metadata.at("candela.bias"), Contains("neural network"));

  CHECK(runCandela({"denoise", film, "-o", b, "--denoise=oidn", "--device", "cpu"}, kStub).exitCode == 0);
  CHECK(image::readImage(b).rgb == denoised.rgb);
}

TEST_CASE("plain --denoise does not load Open Image Denoise") {
  const TemporaryFolder folder;
  const std::string a = folder.path("a.exr"), b = folder.path("b.exr");
  REQUIRE(renderWall(folder, {"--denoise", "-o", a}, kStub).exitCode == 0);
  REQUIRE(renderWall(folder, {"-o", b, "--denoise"}, kNoLibrary).exitCode == 0);
  CHECK(readText(a) == readText(b));
  CHECK_THAT(image::readImage(a).metadata.at("candela.denoised"), Contains("by statistics"));
}

TEST_CASE("a missing Open Image Denoise is an error before the render, with the remedy") {
  const TemporaryFolder folder;
  const ProgramResult result = renderWall(folder, {"--denoise", "oidn", "-o", folder.path("a.png")}, kNoLibrary);
  CHECK(result.exitCode == 4);
  CHECK_THAT(result.err, Contains("the library Open Image Denoise cannot be loaded: libOpenImageDenoise.so.2") &&
                             Contains("https://github.com/RenderKit/oidn"));
  CHECK(folder.fileCount() == 1);
  const ProgramResult wrong = renderWall(folder, {"--denoise=optix", "-o", folder.path("a.png")}, kStub);
  CHECK(wrong.exitCode == 1);
  CHECK_THAT(wrong.err, Contains("--denoise: expected no value or oidn, got \"optix\""));
}

TEST_CASE("a render is not lost if Open Image Denoise fails") {
  const TemporaryFolder folder;
  const std::string a = folder.path("a.exr");
  const ProgramResult result = renderWall(folder, {"--size", "1x5", "--denoise", "oidn", "-o", a}, kStub);
  CHECK(result.exitCode == 0);
  CHECK_THAT(result.err, Contains("warning: Open Image Denoise: the image is too narrow; the image is denoised by the "
                                  "statistics of its pixels instead"));
  CHECK_THAT(image::readImage(a).metadata.at("candela.denoised"), Contains("by statistics"));
}

}  // namespace candela

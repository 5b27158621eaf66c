// Denoising as a user requests it, and refused requests.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "host/image/image.h"
#include "host/image/metrics.h"
#include "tests/app/cli/run_program.h"

namespace candela {
namespace {

using Catch::Contains;

ProgramResult renderSmall(const TemporaryFolder& folder, std::vector<std::string> options) {
  options.insert(options.begin(), {folder.write("a.p3f", smallScene()), "--device", "cpu", "--size", "24x18"});
  return runCandela(options);
}

}  // namespace

TEST_CASE("a denoised render and its film denoised later are the same image, which states that it is biased") {
  const TemporaryFolder folder;
  const std::string film = folder.path("film.exr"), a = folder.path("a.exr"), b = folder.path("b.exr");
  REQUIRE(renderSmall(folder, {"--spp", "8", "--denoise", "--checkpoint", film, "-o", a}).exitCode == 0);
  const ProgramResult result = runCandela({"denoise", film, "-o", b, "--device", "cpu"});
  CHECK(result.exitCode == 0);
  CHECK_THAT(result.err, Contains("24x18 pixels denoised"));
  const image::Image denoised = image::readImage(b);
  CHECK(denoised.rgb == image::readImage(a).rgb);
  CHECK(denoised.rgb != image::readImage(film).rgb);
  CHECK(denoised.luminanceVariance.empty());
  CHECK_THAT(denoised.metadata.at("candela.bias"), Contains("denoised"));
  CHECK(denoised.metadata.contains("candela.denoised"));
}

TEST_CASE("the program states how much light of isolated bright samples it has removed") {
  const TemporaryFolder folder;
  const std::string a = folder.path("a.exr"), film = folder.path("film.exr");
  const std::string tinyLamp = "f 1 1 1 1 0 0 0 0 1 1 1 90000 90000 90000\ns 0 0 9 0.4\n";
  const ProgramResult result = runCandela({folder.write("a.p3f", smallScene(tinyLamp)), "--device", "cpu", "--size",
                                           "24x18", "--spp", "16", "--nee", "off", "--denoise", "--checkpoint", film,
                                           "-o", a});
  REQUIRE(result.exitCode == 0);
  CHECK_THAT(result.err,
             Contains("isolated bright samples in") && Contains("of 432 pixels were limited, which removed"));
  const image::Image denoised = image::readImage(a);
  CHECK_THAT(denoised.metadata.at("candela.bias"), Contains("isolated bright samples in"));
  CHECK(image::compareImages(denoised, image::readImage(film)).relativeMeanDifference < -0.1);
}

TEST_CASE("a film of --denoise is that of --aov moments") {
  const TemporaryFolder folder;
  const std::string a = folder.path("a.exr"), b = folder.path("b.exr");
  REQUIRE(renderSmall(folder, {"--spp", "4", "--denoise", "--checkpoint", a}).exitCode == 0);
  REQUIRE(renderSmall(folder, {"--spp", "4", "--aov", "moments", "--checkpoint", b}).exitCode == 0);
  CHECK(readText(a) == readText(b));
}

TEST_CASE("there is no verdict on the light of denoised images, and --alpha is refused") {
  const TemporaryFolder folder;
  const std::string a = folder.path("a.exr"), b = folder.path("b.exr");
  REQUIRE(renderSmall(folder, {"--spp", "4", "--seed", "1", "--denoise", "-o", a}).exitCode == 0);
  REQUIRE(renderSmall(folder, {"--spp", "4", "--seed", "2", "-o", b}).exitCode == 0);
  const ProgramResult silent = runCandela({"compare", a, b});
  CHECK(silent.exitCode == 0);
  CHECK_THAT(silent.out, Contains("There is no verdict on the light: A is biased on purpose") && Contains("denoised"));
  const ProgramResult asked = runCandela({"compare", a, b, "--alpha", "0.01"});
  CHECK(asked.exitCode == 1);
  CHECK_THAT(asked.err, Contains("--alpha: A is biased on purpose"));
}

TEST_CASE("films that cannot be denoised are refused with the remedy") {
  const TemporaryFolder folder;
  const std::string film = folder.path("film.exr"), image = folder.path("a.png");
  REQUIRE(renderSmall(folder, {"--spp", "4", "--checkpoint", film}).exitCode == 0);
  const ProgramResult plain = runCandela({"denoise", film, "-o", image});
  CHECK(plain.exitCode == 2);
  CHECK_THAT(plain.err, Contains(film + ": the film lacks the sums that denoising needs; render it again with --aov"));
  CHECK_THAT(runCandela({"denoise", film}).err, Contains("no output given: name an image file with -o FILE"));
  CHECK(runCandela({"denoise", folder.path("none.exr"), "-o", image}).exitCode == 2);
  CHECK(runCandela({"denoise", "-o", image}).exitCode == 1);
}

TEST_CASE("renders that cannot be denoised are refused before they start") {
  const TemporaryFolder folder;
  const std::string image = folder.path("a.png");
  const ProgramResult one = renderSmall(folder, {"--spp", "1", "--denoise", "-o", image});
  CHECK(one.exitCode == 1);
  CHECK_THAT(one.err, Contains("denoising needs at least two samples per pixel"));
  const ProgramResult other = renderSmall(folder, {"--integrator", "whitted", "--denoise", "-o", image});
  CHECK(other.exitCode == 1);
  CHECK_THAT(other.err, Contains("only the path tracer has the statistics that denoising needs"));
}

TEST_CASE("a denoised render that was stopped is denoised, or stays as it is if no pixel has two samples") {
  const TemporaryFolder folder;
  const std::string image = folder.path("a.exr");
  const ProgramResult result = renderSmall(folder, {"--spp", "100000", "--time-limit", "0s", "--denoise", "-o", image});
  CHECK(result.exitCode == 7);
  // How many samples there are until the limit is noticed depends on the machine.
  const bool isNoisy = contains(result.err,
                                "the image is not denoised: denoising needs at least two samples per pixel");
  CHECK(isNoisy != image::readImage(image).metadata.contains("candela.denoised"));
}

}  // namespace candela

// `candela compare A B`: figures and verdicts.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "host/image/image.h"
#include "tests/cli/run_program.h"

namespace candela {
namespace {

using nlohmann::json;

// 8x8 pixels of one grey.
std::string writeGrey(const TemporaryFolder& folder, const std::string& name, float value, std::uint32_t side = 8) {
  image::Image image;
  image.width = side;
  image.height = side;
  image.rgb.assign(std::size_t{side} * side, glm::vec3(value));
  writeImage(folder.path(name), image, {});
  return folder.path(name);
}

}  // namespace

TEST_CASE("equal images compare equal, at any tolerance") {
  const TemporaryFolder folder;
  const std::string a = writeGrey(folder, "a.exr", 0.5f);
  const std::string b = writeGrey(folder, "b.pfm", 0.5f);
  const ProgramResult equal = runCandela({"compare", a, b});
  CHECK(equal.exitCode == 0);
  CHECK(contains(equal.out, "the images are identical\n"));
  CHECK(contains(equal.out, "\nPSNR                  infinite\n"));
  CHECK(contains(equal.out, "\nFLIP                  mean 0, maximum 0\n"));
  CHECK(runCandela({"compare", a, b, "--tolerance", "0"}).exitCode == 0);
}

TEST_CASE("arguments that are neither two images nor one scene are refused with the reason") {
  const ProgramResult scenes = runCandela({"compare", "a.p3f", "b.GLB"});
  CHECK(scenes.exitCode == 1);
  CHECK(contains(scenes.err, "compare takes two images or one scene, and a.p3f is a scene"));
  CHECK(contains(runCandela({"compare", "a.exr"}).err, "compare a.exr: the second image is missing"));
}

TEST_CASE("the verdict is relMSE against the tolerance") {
  const TemporaryFolder folder;
  const std::string a = writeGrey(folder, "a.exr", 0.75f);
  const std::string b = writeGrey(folder, "b.exr", 0.5f);
  // (0.75 - 0.5)^2 / (0.5^2 + 0.01) = 0.0625 / 0.26 = 0.24038...
  CHECK(runCandela({"compare", a, b}).exitCode == 0);
  CHECK_FALSE(contains(runCandela({"compare", a, b}).out, "identical"));
  CHECK(runCandela({"compare", a, b, "--tolerance", "0.2404"}).exitCode == 0);
  CHECK(runCandela({"compare", a, b, "--tolerance", "0.2403"}).exitCode == 3);
  const json report = json::parse(runCandela({"compare", a, b, "--json", "-"}).out);
  CHECK(report["relativeMeanSquaredError"].get<double>() == Approx(0.0625 / 0.26));
  CHECK(report["relativeMeanDifference"].get<double>() == Approx(0.5));
  CHECK(report["worst"]["difference"].get<double>() == Approx(0.25));
  CHECK(report["differingFraction"] == 1.0);
  CHECK(report["meanFlip"].get<double>() > 0);
}

TEST_CASE("pictures of the differences are written on request") {
  const TemporaryFolder folder;
  const std::string a = writeGrey(folder, "a.exr", 0.75f);
  const std::string b = writeGrey(folder, "b.exr", 0.5f);
  const std::string difference = folder.path("difference.png");
  const std::string flip = folder.path("flip.png");
  CHECK(runCandela({"compare", a, b, "--diff", difference, "--flip", flip, "-q"}).exitCode == 0);
  CHECK(image::readPixels8(difference).width == 8);
  CHECK(image::readPixels8(flip).height == 8);
}

TEST_CASE("images that cannot be compared are an error, and nothing is written") {
  const TemporaryFolder folder;
  const std::string a = writeGrey(folder, "a.exr", 0.5f);
  const std::string small = writeGrey(folder, "small.exr", 0.5f, 4);
  const std::string broken = folder.write("broken.exr", "no image");
  const std::string difference = folder.path("difference.png");
  CHECK(runCandela({"compare", a, small, "--diff", difference}).exitCode == 1);
  CHECK(runCandela({"compare", a, broken, "--diff", difference}).exitCode == 2);
  CHECK(runCandela({"compare", a, folder.path("missing.exr"), "--diff", difference}).exitCode == 2);
  CHECK(folder.fileCount() == 3);
}

TEST_CASE("a value that is not a number exceeds any tolerance") {
  const TemporaryFolder folder;
  const std::string a = writeGrey(folder, "a.exr", std::numeric_limits<float>::quiet_NaN());
  const std::string b = writeGrey(folder, "b.exr", 0.5f);
  CHECK(runCandela({"compare", a, b, "--tolerance", "1e9"}).exitCode == 3);
}

TEST_CASE("the reference cannot be verified against itself") {
  const TemporaryFolder folder;
  const ProgramResult result = runCandela({"verify", folder.write("a.p3f", smallScene()), "--device", "cpu"});
  CHECK(result.exitCode == 1);
  CHECK_THAT(result.err, Catch::Contains("the reference tracer cannot verify itself"));
}

TEST_CASE("fractions are parsed as numbers and as percentages") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  for (const char* bias : {"5 %", "%", "-1%", "200%", "0"}) {
    const ProgramResult result = runCandela({"verify", scene, "--bias", bias});
    CHECK(result.exitCode == 1);
    CHECK_THAT(result.err, Catch::Contains("--bias: expected a fraction from"));
  }
}

}  // namespace candela

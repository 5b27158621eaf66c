// `candela compare A B`: figures and verdicts.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "host/image/image.h"
#include "tests/app/cli/run_program.h"
#include "tests/image/read_pixels8.h"

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
  CHECK(runCandela({"compare", a, small, "--diff", difference}).exitCode == 3);
  CHECK(runCandela({"compare", a, broken, "--diff", difference}).exitCode == 2);
  CHECK(runCandela({"compare", a, folder.path("missing.exr"), "--diff", difference}).exitCode == 2);
  CHECK(folder.fileCount() == 3);
}

TEST_CASE("pictures in different places differ, whatever the tolerance") {
  const TemporaryFolder folder;
  image::Image image{4, 4, std::vector<glm::vec3>(16, glm::vec3(0.5f)), {}, {}, {}, {}};
  image.frame = image::PixelBox{0, 0, 8, 8};
  const auto writeAt = [&](const char* name, std::int64_t x) {
    image.origin.x = x;
    writeImage(folder.path(name), image, {});
    return folder.path(name);
  };
  const std::string left = writeAt("left.exr", 0), right = writeAt("right.exr", 4);
  const ProgramResult apart = runCandela({"compare", left, right});
  CHECK(apart.exitCode == 3);
  CHECK(contains(apart.out, "pixel by pixel: A has the window 0,0,4,4 of the frame and B the window 4,0,4,4"));
  const json report = json::parse(runCandela({"compare", left, right, "--tolerance", "1e9", "--json", "-"}).out);
  CHECK(report["agrees"] == false);
  CHECK(report.contains("apart"));

  image.frame.reset();
  const std::string frame = writeAt("frame.exr", 0);
  const ProgramResult frames = runCandela({"compare", left, frame, "--diff", folder.path("difference.png")});
  CHECK(frames.exitCode == 3);
  CHECK(contains(frames.out, "pixel by pixel: A has the size 8x8 and B the size 4x4."));
  CHECK(contains(frames.err, "none is written"));
  CHECK(folder.fileCount() == 3);
}

TEST_CASE("a crop agrees with its picture, and positions are those of the picture") {
  const TemporaryFolder folder;
  image::Image whole;
  whole.width = whole.height = 8;
  for (int i = 0; i < 64; ++i) whole.rgb.emplace_back(static_cast<float>(i));
  image::Image crop = partOf(whole, {2, 3, 4, 4});
  writeImage(folder.path("whole.exr"), whole, {});
  writeImage(folder.path("crop.exr"), crop, {});
  const ProgramResult same = runCandela(
      {"compare", folder.path("crop.exr"), folder.path("whole.exr"), "--tolerance", "0"});
  CHECK(same.exitCode == 0);
  CHECK(contains(same.out, "window                2,3,4,4 of the frame 0,0,8,8\n"));
  crop.at(1, 1) += 1.0f;
  writeImage(folder.path("crop.exr"), crop, {});
  const json other = json::parse(
      runCandela({"compare", folder.path("whole.exr"), folder.path("crop.exr"), "--json", "-"}).out);
  CHECK(other["window"] == "2,3,4,4");
  CHECK(other["worst"]["x"] == 3);
  CHECK(other["worst"]["y"] == 4);
}

TEST_CASE("alpha and layers are compared with the tolerance, and --channels selects") {
  const TemporaryFolder folder;
  image::Image image{2, 1, std::vector<glm::vec3>(2, glm::vec3(0.5f)), {}, {}, {}, {}};
  image.alpha = {1, 0.25f};
  image.channels = {{"Z", {1, 2}}, {"N.X", {0, 1}}};
  writeImage(folder.path("a.exr"), image, {});
  image.alpha = {1, 0.5f};
  image.channels = {{"Z", {1, 2}}};
  writeImage(folder.path("b.exr"), image, {});
  const auto compare = [&](const std::vector<std::string>& options) {
    std::vector<std::string> words{"compare", folder.path("a.exr"), folder.path("b.exr")};
    words.insert(words.end(), options.begin(), options.end());
    return runCandela(words);
  };
  const ProgramResult result = compare({"--tolerance", "0"});
  CHECK(result.exitCode == 3);
  CHECK(contains(result.out, "FAIL: the tolerance of relMSE is 0, beyond which are: A\n"));
  CHECK(contains(result.out, "channel Z             equal\n"));
  CHECK(contains(result.out, "only in A             N.X\n"));
  CHECK(!contains(result.out, "identical"));
  CHECK(compare({"--tolerance", "0", "--channels", "R,G,B,Z"}).exitCode == 0);
  CHECK(compare({"--tolerance", "0", "--channels", "A"}).exitCode == 3);
  CHECK(compare({"--channels", "normal"}).exitCode == 1);
  CHECK(compare({"--channels", "R,,G"}).exitCode == 1);
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

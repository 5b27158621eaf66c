// `candela compare A... --with B...`: exit codes, texts, documents and refusals.
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "host/image/image.h"
#include "tests/app/cli/run_program.h"
#include "tests/image/read_pixels8.h"

namespace candela {
namespace {

using Catch::Contains;
using nlohmann::json;
using Words = std::vector<std::string>;

// Renders of the small scene by the reference, with seeds from `seed` on.
Words renderSet(const TemporaryFolder& folder, const std::string& name, int seed, int count,
                const std::string& lamp = "4 4 4") {
  std::string text = smallScene();
  text.replace(text.find("4 4 4"), 5, lamp);
  const std::string scene = folder.write(name + ".p3f", text);
  Words files;
  for (int i = 0; i < count; ++i) {
    files.push_back(folder.path(name + std::to_string(i) + ".exr"));
    const ProgramResult result = runCandela(
        {scene, "-o", files.back(), "--device", "cpu", "--seed", std::to_string(seed + i), "--spp", "32", "-q"});
    REQUIRE(result.exitCode == 0);
  }
  return files;
}

// Grey pictures without a renderer.
std::string writeConstant(const TemporaryFolder& folder, const std::string& name, float value, std::uint32_t side = 4) {
  image::Image image;
  image.width = image.height = side;
  image.rgb.assign(std::size_t{side} * side, glm::vec3(value));
  writeImage(folder.path(name), image, {});
  return folder.path(name);
}

Words greySet(const TemporaryFolder& folder, const std::string& name, const std::vector<float>& values) {
  Words files;
  for (const float value : values) {
    files.push_back(writeConstant(folder, name + std::to_string(files.size()) + ".pfm", value));
  }
  return files;
}

Words words(const Words& a, const Words& b, const Words& options = {}) {
  Words all{"compare"};
  all.insert(all.end(), a.begin(), a.end());
  all.emplace_back("--with");
  all.insert(all.end(), b.begin(), b.end());
  all.insert(all.end(), options.begin(), options.end());
  return all;
}

}  // namespace

TEST_CASE("sets of renders of one scene show the same light, and those of a brighter lamp do not") {
  const TemporaryFolder folder;
  const Words a = renderSet(folder, "a", 1, 6), b = renderSet(folder, "b", 11, 6);
  const Words bright = renderSet(folder, "bright", 21, 6, "5 5 5");
  const ProgramResult same = runCandela(words(a, b, {"--alpha", "5%", "--bias", "20%"}));
  CHECK(same.exitCode == 0);
  CHECK_THAT(same.out, Contains("A and B show the same light within their noise") &&
                           Contains("yes: 6 renders of A and 6 of B, 8 tests together") && Contains("95 % confidence"));
  const ProgramResult differ = runCandela(words(a, bright, {"--alpha", "5%"}));
  CHECK(differ.exitCode == 3);
  CHECK_THAT(differ.out, Contains("do NOT show the same light"));
  CHECK(runCandela(words(bright, a, {"--alpha", "5%"})).exitCode == 3);
}

TEST_CASE("too few renders are not decided, with an exit code of its own, unless that is allowed") {
  const TemporaryFolder folder;
  const Words a = greySet(folder, "a", {1, 2, 3}), b = greySet(folder, "b", {11, 12, 13});
  const ProgramResult few = runCandela(words(a, b));
  CHECK(few.exitCode == 8);
  CHECK_THAT(few.out,
             Contains("Not decided: the p-value of 3 renders of A and 3 of B is at least 0.1, and the level is "
                      "0.0001. At least 9 renders on each side, or a larger --alpha, would decide it."));
  CHECK(runCandela(words(a, b, {"--allow-undecided"})).exitCode == 0);
  CHECK(runCandela(words(a, b, {"--alpha", "0.1"})).exitCode == 3);
}

TEST_CASE("pairs find what is hidden by the noise that both sets share") {
  const TemporaryFolder folder;
  const Words a = greySet(folder, "a", {1, 2, 3, 4, 5, 6}),
              b = greySet(folder, "b", {1.1f, 2.11f, 3.1f, 4.12f, 5.1f, 6.1f});
  CHECK(runCandela(words(a, b, {"--alpha", "5%"})).exitCode == 8);
  const ProgramResult paired = runCandela(words(a, b, {"--alpha", "5%", "--paired"}));
  CHECK(paired.exitCode == 3);
  CHECK_THAT(paired.out, Contains("NO: 6 pairs"));
  CHECK(runCandela(words(a, a, {"--paired"})).exitCode == 0);
  CHECK_THAT(runCandela(words(a, a)).err, Contains("a0.pfm equals") && Contains("--paired finds smaller differences"));
}

TEST_CASE("the document, the page and the pictures of two sets are written") {
  const TemporaryFolder folder;
  const Words a = greySet(folder, "a", {1, 1.1f, 1.2f, 1.3f}), b = greySet(folder, "b", {2, 2.1f, 2.2f, 2.3f});
  const std::string page = folder.path("page.html"), difference = folder.path("difference.png");
  const ProgramResult result = runCandela(words(
      a, b,
      {"--alpha", "0.05", "--json", "-", "--report", page, "--diff", difference, "--flip", folder.path("flip.png")}));
  CHECK(result.exitCode == 3);
  const json report = json::parse(result.out);
  CHECK(report["schema"] == "candela-compare-renders/1");
  CHECK(report["agrees"] == false);
  CHECK(report["filesOfA"].size() == 4);
  CHECK(report["rendersOfB"] == 4);
  CHECK(report["pValue"].get<double>() == Approx(2.0 / 70));
  CHECK(report["minPValue"] == report["pValue"]);
  CHECK(report["allDivisions"] == true);
  CHECK(report["regions"][0]["differenceFraction"].get<double>() == Approx(-1 / 2.15));
  CHECK(report["regions"][0]["differenceLowFraction"].get<double>() < -1 / 2.15);
  CHECK(report["regions"][0]["agrees"] == false);
  CHECK_THAT(readText(page),
             Contains("They differ") && Contains("Mean of 4 renders") && Contains("p-values that count all"));
  CHECK(image::readPixels8(difference).width == 4);
}

TEST_CASE("files that cannot be renders of a set are refused by name, and nothing is written") {
  const TemporaryFolder folder;
  const Words a = greySet(folder, "a", {1, 2}), b = greySet(folder, "b", {3, 4});
  const std::string page = folder.path("page.html");
  const auto refusalOf = [&](const std::string& file) {
    const ProgramResult result = runCandela(words({a[0], file}, b, {"--report", page}));
    CHECK(result.exitCode == 2);
    return result.err;
  };
  CHECK_THAT(refusalOf(writeConstant(folder, "shown.png", 0.5f)), Contains("shown.png: a display transform"));
  CHECK_THAT(refusalOf(writeConstant(folder, "wide.exr", 1, 8)),
             Contains("wide.exr: it has the size 8x8, and the renders before it"));
  CHECK_THAT(refusalOf(writeConstant(folder, "nan.exr", NAN)),
             Contains("nan.exr: the pixel 0,0 is not finite (16 such pixels)"));
  CHECK_THAT(refusalOf(writeConstant(folder, "twin.exr", 1)),
             Contains("twin.exr: it equals") && Contains("different random numbers"));
  CHECK_THAT(refusalOf(folder.write("broken.exr", "no image")), Contains("broken.exr"));
  CHECK(runCandela(words(a, {folder.path("missing.exr")})).exitCode == 2);
  CHECK_THAT(runCandela(words(a, {folder.path("wide.exr")})).err,
             Contains("wide.exr: it has the size 8x8") && Contains("a0.pfm"));
  CHECK_FALSE(std::filesystem::exists(page));
}

TEST_CASE("renders are compared with one picture that has variances, and numbers of samples must be known") {
  const TemporaryFolder folder;
  const Words a = renderSet(folder, "a", 1, 6), bright = renderSet(folder, "bright", 21, 6, "5 5 5");
  const std::string picture = folder.path("picture.exr");
  REQUIRE(runCandela({folder.path("a.p3f"), "-o", picture, "--device", "cpu", "--seed", "50", "--spp", "256",
                      "--sampler", "independent", "-q"})
              .exitCode == 0);
  const ProgramResult same = runCandela(words(a, {picture}, {"--bias", "60%"}));
  CHECK(same.exitCode == 0);
  CHECK_THAT(same.out, Contains("6 renders of A and one picture with variances, 5 tests together"));
  CHECK(runCandela(words(bright, {picture}, {"--alpha", "1%"})).exitCode == 3);
  CHECK(runCandela(words({bright[0]}, {picture})).exitCode == 3);  // variances of its own
  CHECK_THAT(runCandela(words(a, {a[0]})).err, Contains("has the same seed, 1"));
  const json report = json::parse(runCandela(words(a, {picture}, {"--json", "-"})).out);
  CHECK(report["design"] == "picture");

  const Words grey = greySet(folder, "grey", {1, 2, 3});
  const std::string plain = writeConstant(folder, "plain.pfm", 2),
                    variance = writeConstant(folder, "variance.exr", 100);
  CHECK_THAT(runCandela(words(grey, {plain}, {"--with-spp", "4"})).err,
             Contains("--with-spp is for a comparison with one picture"));
  CHECK_THAT(runCandela(words(grey, {plain}, {"--with-variance", variance})).err,
             Contains("plain.pfm: its variances need its number of samples per pixel; --with-spp"));
  CHECK_THAT(runCandela(words(grey, {plain}, {"--with-variance", variance, "--with-spp", "1000"})).err,
             Contains("grey0.pfm: a comparison with one picture needs its number of samples per pixel; --set-spp"));
  const Words known{"--with-variance", variance, "--with-spp", "1000", "--set-spp", "8"};
  CHECK(runCandela(words(grey, {plain}, known)).exitCode == 8);
  CHECK_THAT(runCandela(words({grey[0]}, {plain}, known)).err,
             Contains("a single render without them does not show its noise"));
  CHECK_THAT(
      runCandela(words(grey, {plain}, {"--with-variance", writeConstant(folder, "bad.exr", -1), "--with-spp", "9"}))
          .err,
      Contains("bad.exr: a variance of luminance is negative"));
}

TEST_CASE("options that two sets do not have are refused with the reason") {
  const TemporaryFolder folder;
  const Words a = greySet(folder, "a", {1, 2}), b = greySet(folder, "b", {3, 4, 5});
  const auto refusalOf = [&](const Words& options) {
    const ProgramResult result = runCandela(words(a, b, options));
    CHECK(result.exitCode == 1);
    return result.err;
  };
  CHECK_THAT(refusalOf({"--tolerance", "1"}), Contains("--tolerance is for comparing two images, not two sets"));
  CHECK_THAT(refusalOf({"--channels", "R"}), Contains("--channels is for comparing two images"));
  CHECK_THAT(refusalOf({"--spp", "4"}), Contains("--spp is for comparing one scene, not two images"));
  CHECK_THAT(refusalOf({"--alpha", "1e-9"}), Contains("--alpha 1e-09: the minimum of a permutation test is 1e-06"));
  CHECK_THAT(refusalOf({"--paired"}), Contains("--paired: both sets need equal numbers of renders, and have 2 and 3"));
  CHECK_THAT(runCandela({"compare", a[0], a[1], b[0]}).err, Contains("b0.pfm is unexpected; --with names"));
  CHECK_THAT(runCandela({"compare", a[0], a[1], "--paired"}).err, Contains("--paired has no effect without --with"));
  CHECK(runCandela({"compare", a[0], "--with"}).exitCode == 1);
  CHECK(runCandela({"compare", "--with", b[0]}).exitCode == 1);
  CHECK(runCandela({"compare", "--with", b[0], b[1], "--with", b[2], "--alpha=5%", a[0], a[1]}).exitCode == 8);
}

}  // namespace candela

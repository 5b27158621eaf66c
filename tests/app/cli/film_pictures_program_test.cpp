// Descriptions of film files, and the pictures that are made of them, on the reference tracer.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "host/image/image.h"
#include "tests/app/cli/film_runs.h"

namespace candela {
namespace {

using Catch::Contains;
using nlohmann::json;

}  // namespace

TEST_CASE("a film with layers can be divided, lists them, and gives the pictures that the render gives") {
  const TemporaryFolder folder;
  const std::string list = "normal,albedo,depth,position,uv,direct,indirect,emission";
  requireEqualDivisions(kReference, folder, {"--aov", list});

  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string film = folder.path("film.exr");
  kReference.film(scene, film, {"-o", folder.path("a.exr"), "--aov", list});
  const std::string report = folder.path("film.json");
  REQUIRE(runCandela({"film", film, "--json", report, "-o", folder.path("b.exr")}).exitCode == 0);
  CHECK(jsonOf(report)["layers"] == list);
  CHECK_THAT(runCandela({"film", film}).out, Contains("layers           " + list));
  const image::Image a = image::readImage(folder.path("a.exr")), b = image::readImage(folder.path("b.exr"));
  CHECK(a.rgb == b.rgb);
  REQUIRE(runCandela({"film", film, "-o", folder.path("c.exr")}).exitCode == 0);
  CHECK(readText(folder.path("b.exr")) == readText(folder.path("c.exr")));
  for (const char* name : {"N.X", "albedo.G", "uv.V", "indirect.B", "emission.R"}) {
    CHECK(readText(folder.path("b.exr")).find(name) != std::string::npos);
  }
}

TEST_CASE("a film with alpha can be divided, and gives the pictures that the render gives") {
  const TemporaryFolder folder;
  const std::vector<std::string> options{"--background", "none", "--env", "white"};
  requireEqualDivisions(kReference, folder, options);

  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string film = folder.path("film.exr");
  std::vector<std::string> words{"-o", folder.path("a.png"), "-o", folder.path("a.exr")};
  words.insert(words.end(), options.begin(), options.end());
  kReference.film(scene, film, words);
  REQUIRE(runCandela({"film", film, "-o", folder.path("b.png"), "-o", folder.path("b.exr")}).exitCode == 0);
  CHECK(readText(folder.path("a.png")) == readText(folder.path("b.png")));
  const std::vector<float> alpha = image::readImage(folder.path("a.exr")).alpha;
  CHECK(alpha == image::readImage(folder.path("b.exr")).alpha);
  CHECK(std::ranges::count(alpha, 0.0f) > 10);
  CHECK(std::ranges::count(alpha, 1.0f) > 10);
  CHECK(json::parse(runCandela({"film", film, "--json", "-"}).out)["settings"]["background"] == "none");
  CHECK_THAT(kReference.refusal(scene, {"--env", "white", "--resume", film}),
             Contains("--background is none in the film and absent in this render"));
}

TEST_CASE("films without alpha are those of renders without --background") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string film = kReference.film(scene, folder.path("a.exr"));
  CHECK(kReference.film(scene, folder.path("b.exr"), {"--background", "env"}) == film);
  CHECK_THAT(film, Contains("\"format\":1") && !Contains("background") && !Contains("hits"));
  const ProgramResult whitted = kReference.run(
      scene, {"--background", "none", "--integrator", "whitted", "-o", folder.path("a.png")});
  CHECK(whitted.exitCode == 1);
  CHECK_THAT(whitted.err, Contains("--background none applies only to the path tracer"));
}

TEST_CASE("pictures of limited indirect light say so, and get no verdict") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  for (const std::string seed : {"1", "2"}) {
    kReference.film(scene, folder.path(seed + "film.exr"),
                    {"--clamp-indirect", "0.5", "--seed", seed, "-o", folder.path(seed + ".exr")});
  }
  REQUIRE(runCandela({"film", folder.path("1film.exr"), "-o", folder.path("again.exr")}).exitCode == 0);
  for (const char* name : {"1.exr", "again.exr"}) {
    const image::Image picture = image::readImage(folder.path(name));
    REQUIRE(picture.metadata.contains("candela.bias"));
    CHECK_THAT(picture.metadata.at("candela.bias"), Contains("--clamp-indirect 0.5"));
  }
  const ProgramResult result = runCandela({"compare", folder.path("1.exr"), folder.path("2.exr")});
  CHECK_THAT(result.out + result.err, Contains("biased on purpose"));
  CHECK(runCandela({"compare", folder.path("1.exr"), folder.path("2.exr"), "--alpha", "1e-4"}).exitCode == 1);
}

TEST_CASE("a crop has the pixels of the full image, in pictures as in films") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  REQUIRE(kReference.run(scene, {"-o", folder.path("full.exr")}).exitCode == 0);
  REQUIRE(kReference.run(scene, {"-o", folder.path("crop.exr"), "--crop", "11,7,20,9"}).exitCode == 0);
  const image::Image full = image::readImage(folder.path("full.exr"));
  const image::Image crop = image::readImage(folder.path("crop.exr"));
  REQUIRE(crop.width == 20);
  REQUIRE(crop.height == 9);
  CHECK(crop.metadata.at("candela.crop") == "11,7,20,9");
  CHECK(windowOf(crop) == image::PixelBox{11, 7, 20, 9});
  CHECK(frameOf(crop) == windowOf(full));
  CHECK(runCandela({"compare", folder.path("crop.exr"), folder.path("full.exr"), "--tolerance", "0"}).exitCode == 0);
  for (std::uint32_t y = 0; y < 9; ++y) {
    for (std::uint32_t x = 0; x < 20; ++x) CHECK(crop.at(x, y) == full.at(11 + x, 7 + y));
  }
}

TEST_CASE("candela film describes a film, and makes the pictures that the render makes") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string film = folder.path("film.exr");
  for (const std::vector<std::string>& options :
       std::vector<std::vector<std::string>>{{}, {"--integrator", "depth"}, {"--integrator", "cost"}}) {
    std::vector<std::string> words{"-o", folder.path("a.png"), "-o", folder.path("a.hdr"), "--checkpoint", film};
    words.insert(words.end(), options.begin(), options.end());
    REQUIRE(kReference.run(scene, words).exitCode == 0);
    REQUIRE(
        runCandela({"film", film, "-o", folder.path("b.png"), "-o", folder.path("b.hdr"), "-o", folder.path("b.exr")})
            .exitCode == 0);
    CHECK(readText(folder.path("a.png")) == readText(folder.path("b.png")));
    CHECK(readText(folder.path("a.hdr")) == readText(folder.path("b.hdr")));
    CHECK(image::readImage(folder.path("b.exr")).rgb == image::readImage(film).rgb);
    const ProgramResult text = runCandela({"film", film});
    CHECK_THAT(text.out, Contains("contains") && Contains("samples 0:12 of crop 0,0,48,36") && Contains("cpu"));
    std::filesystem::remove(film);
  }
}

TEST_CASE("a film names every option that decides the image or how the scene is read, but no path") {
  const TemporaryFolder folder;
  const std::string film = folder.path("film.exr");
  kReference.film(folder.write("a.p3f", smallScene()), film);
  const json settings = json::parse(runCandela({"film", film, "--json", "-"}).out)["settings"];
  for (const char* name : {"integrator", "sampler", "maxDepth", "oneSided", "lenient", "camera", "time"}) {
    CHECK(settings.contains(name));
  }
  CHECK_FALSE(settings.contains("allowPath"));
  CHECK(settings["camera"].is_null());
  CHECK(settings["time"].is_null());
  CHECK(settings["maxDepth"] == 64);
  CHECK_THAT(runCandela({"film", film}).out, Contains("settings         --filter box --max-depth 64\n"));
}

TEST_CASE("two film files are compared as pictures with variance") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  kReference.film(scene, folder.path("a.exr"), {"--seed", "1"});
  kReference.film(scene, folder.path("b.exr"), {"--seed", "2"});
  const ProgramResult result = runCandela({"compare", folder.path("a.exr"), folder.path("b.exr"), "--json", "-"});
  CHECK(result.exitCode == 0);
  CHECK(result.err.find("badSamples") == std::string::npos);
}

}  // namespace candela

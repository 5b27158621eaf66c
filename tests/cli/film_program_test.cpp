// Films, checkpoints and merging as a person uses them, on the reference tracer.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "host/image/image.h"
#include "tests/cli/film_runs.h"

namespace candela {
namespace {

using Catch::Contains;
using nlohmann::json;
using std::chrono::milliseconds;

const FilmRuns kReference{{"--device", "cpu", "--size", "48x36", "--spp", "12"}};

// A render of about a second on one thread.
const FilmRuns kLong{{"--device", "cpu", "--threads", "1", "--size", "64x48", "--spp", "256"}};

json jsonOf(const std::string& file) { return json::parse(readFile(file)); }

}  // namespace

TEST_CASE("the file of a film does not depend on how its samples were divided, nor on the order of merging") {
  const TemporaryFolder folder;
  requireEqualDivisions(kReference, folder, {"--seed", "5"});
}

TEST_CASE("a film of every integrator and sampler can be divided") {
  for (const std::vector<std::string>& options :
       std::vector<std::vector<std::string>>{{"--integrator", "whitted"},
                                             {"--integrator", "ao"},
                                             {"--integrator", "cost"},
                                             {"--sampler", "stratified"},
                                             {"--sampler", "independent", "--filter", "tent"},
                                             {"--spp", "16", "--nee", "off"}}) {
    const TemporaryFolder folder;
    INFO(options[0] << " " << options[1]);
    requireEqualDivisions(kReference, folder, options);
  }
}

TEST_CASE("a film goes on to more samples per pixel as if they had been asked for at once") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string whole = kReference.film(scene, folder.path("whole.exr"), {"--spp", "20"});
  const std::string part = folder.path("part.exr");
  kReference.film(scene, part, {"--spp", "7"});
  CHECK(kReference.film(scene, folder.path("rest.exr"), {"--spp", "20", "--resume", part}) == whole);
  // The file that is resumed may be the one that is written.
  CHECK(kReference.film(scene, part, {"--spp", "20", "--resume", part}) == whole);
  CHECK(jsonOf(part + ".json")["runs"] == 2);
  CHECK(jsonOf(part + ".json")["counts"]["samples"] == 48 * 36 * 20);
  CHECK(jsonOf(part + ".json")["counts"] == jsonOf(folder.path("whole.exr") + ".json")["counts"]);
}

TEST_CASE("films whose samples depend on their number do not go on to another") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string strata = folder.path("strata.exr");
  kReference.film(scene, strata, {"--sampler", "stratified"});
  CHECK_THAT(kReference.refusal(scene, {"--sampler", "stratified", "--spp", "24", "--resume", strata}),
             Contains("--spp 12") && Contains("--spp 24") && Contains("strata"));
  const std::string one = folder.path("one.exr");
  kReference.film(scene, one, {"--integrator", "whitted", "--spp", "1"});
  CHECK_THAT(kReference.refusal(scene, {"--integrator", "whitted", "--spp", "2", "--resume", one}),
             Contains("not jittered"));
  const std::string path = folder.path("path.exr");
  kReference.film(scene, path, {"--spp", "1"});
  CHECK(kReference.film(scene, folder.path("b.exr"), {"--spp", "2", "--resume", path}) ==
        kReference.film(scene, folder.path("c.exr"), {"--spp", "2"}));
}

TEST_CASE("a film of another scene, option or window is not resumed, and the first difference is named") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string other = folder.write("b.p3f", smallScene("s 2 2 0 0.25\n"));
  const std::string film = folder.path("film.exr");
  kReference.film(scene, film, {"--samples", "0:4"});
  const auto refusal = [&](const std::string& of, std::vector<std::string> options) {
    options.insert(options.end(), {"--resume", film});
    return kReference.refusal(of, options);
  };
  CHECK_THAT(refusal(other, {}), Contains("film.exr: the scene's hash is"));
  CHECK_THAT(refusal(scene, {"--seed", "1"}), Contains("--seed is 0 in the film and 1 in this render"));
  CHECK_THAT(refusal(scene, {"--max-depth", "3"}), Contains("--max-depth is 64 in the film and 3"));
  CHECK_THAT(refusal(scene, {"--size", "24x36"}), Contains("--size is 48x36"));
  CHECK_THAT(refusal(scene, {"--spp", "0"}), Contains("--antialiasing is absent in the film and off"));
  CHECK_THAT(refusal(scene, {"--crop", "0,0,9,9"}), Contains("state --crop 0,0,48,36"));
  CHECK_THAT(refusal(scene, {"--samples", "5:8"}), Contains("starts at sample 0 and goes to 4"));
  CHECK_THAT(refusal(scene, {"--samples", "0:2"}), Contains("goes to 4"));
  CHECK_THAT(refusal(folder.path("none.p3f"), {}), Contains("none.p3f"));
  CHECK_THAT(kReference.refusal(scene, {"--resume", folder.path("none.exr")}), Contains("none.exr: No such file"));
  CHECK_THAT(kReference.refusal(scene, {"--resume", scene}), Contains("not an OpenEXR file"));
}

TEST_CASE("a film under an environment can be divided") {
  const TemporaryFolder folder;
  requireEqualDivisions(kReference, folder, {"--env", "sun:30,200,3"});
}

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
  CHECK(readFile(folder.path("b.exr")) == readFile(folder.path("c.exr")));
  for (const char* name : {"N.X", "albedo.G", "uv.V", "indirect.B", "emission.R"}) {
    CHECK(readFile(folder.path("b.exr")).find(name) != std::string::npos);
  }
}

TEST_CASE("a film is not resumed nor merged with other layers") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string with = folder.path("with.exr"), without = folder.path("without.exr");
  kReference.film(scene, with, {"--samples", "0:4", "--aov", "normal,variance"});
  kReference.film(scene, without, {"--samples", "4:12"});
  for (const std::vector<std::string>& anyway : std::vector<std::vector<std::string>>{{}, {"--resume-anyway"}}) {
    std::vector<std::string> options{"--resume", with};
    options.insert(options.end(), anyway.begin(), anyway.end());
    CHECK_THAT(kReference.refusal(scene, options),
               Contains("the film has the layers normal, and the render none; state --aov normal"));
  }
  const ProgramResult merged = runCandela({"merge", with, without, "-o", folder.path("merged.exr")});
  CHECK(merged.exitCode == 2);
  CHECK_THAT(merged.err, Contains("--aov is normal in") && Contains("and none in"));
  // Layers without sums make no difference.
  kReference.film(scene, folder.path("rest.exr"), {"--resume", with, "--aov", "normal,samples"});
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
  CHECK(readFile(folder.path("a.png")) == readFile(folder.path("b.png")));
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
  CHECK_THAT(whitted.err, Contains("--background colour and none: only the path tracer"));
}

TEST_CASE("a film goes on under the same environment only, whatever the name of its file") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  image::Image map{4, 2, std::vector<glm::vec3>(8, glm::vec3(0.5f)), {}, {}, {}, {}};
  writeImage(folder.path("map.hdr"), map, {});
  writeImage(folder.path("renamed.hdr"), map, {});
  map.rgb[3].x = 0.75f;
  writeImage(folder.path("changed.hdr"), map, {});
  const std::string film = folder.path("film.exr");
  kReference.film(scene, film, {"--samples", "0:4", "--env", folder.path("map.hdr")});
  const auto refusal = [&](std::vector<std::string> options) {
    options.insert(options.end(), {"--resume", film});
    return kReference.refusal(scene, options);
  };
  CHECK_THAT(refusal({}), Contains("the scene's hash is"));
  CHECK_THAT(refusal({"--env", "white"}), Contains("the scene's hash is"));
  CHECK_THAT(refusal({"--env", folder.path("changed.hdr")}), Contains("the scene's hash is"));
  CHECK_THAT(refusal({"--env", folder.path("map.hdr"), "--env-rotate", "5"}), Contains("the scene's hash is"));
  CHECK_THAT(refusal({"--env", folder.path("none.hdr")}), Contains("none.hdr"));
  const ProgramResult result = kReference.run(
      scene, {"--env", folder.path("renamed.hdr"), "--resume", film, "--checkpoint", folder.path("end.exr")});
  CHECK(result.exitCode == 0);
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

TEST_CASE("with --resume-anyway a film goes on, and is marked as mixed for good") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string film = folder.path("film.exr");
  kReference.film(scene, film, {"--samples", "0:4"});
  const std::string mixed = folder.path("mixed.exr");
  const ProgramResult result = kReference.run(
      scene, {"--seed", "1", "--resume", film, "--resume-anyway", "--checkpoint", mixed});
  CHECK(result.exitCode == 0);
  CHECK_THAT(result.err, Contains("--resume-anyway: --seed is 0 in the film"));
  const json description = json::parse(runCandela({"film", mixed, "--json", "-"}).out);
  CHECK(description["isMixed"] == true);
  CHECK(description["mixed"] == json{"--seed is 0 in an earlier part and 1 in a later part"});
  CHECK(description["samples"] == 48 * 36 * 12);
}

TEST_CASE("a film file is not overwritten by a render that does not go on from it") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string film = folder.path("film.exr");
  const std::string before = kReference.film(scene, film);
  CHECK_THAT(kReference.refusal(scene, {"--checkpoint", film}), Contains("exists") && Contains("--resume " + film));
  CHECK(readFile(film) == before);
  CHECK_THAT(kReference.refusal(scene, {"--checkpoint", "/dev/null"}), Contains("regular file"));
  CHECK_THAT(kReference.refusal(scene, {"--checkpoint", folder.path("no/where.exr")}), Contains("no folder"));
}

TEST_CASE("ranges of --samples and windows of --crop beyond the image are refused") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  CHECK(kReference.run(scene, {"--samples", "8:13", "--stats"}).exitCode == 1);
  CHECK_THAT(kReference.run(scene, {"--samples", "8:13", "--stats"}).err, Contains("12 samples per pixel"));
  for (const char* crop : {"0,0,49,36", "48,0,1,1", "65535,65535,65535,65535"}) {
    const ProgramResult result = kReference.run(scene, {"--crop", crop, "--stats"});
    CHECK(result.exitCode == 1);
    CHECK_THAT(result.err, Contains("not within the image of 48x36 pixels"));
  }
  CHECK(runCandela({scene, "--checkpoint-every", "1s", "--stats"}).exitCode == 1);
  CHECK(runCandela({scene, "--resume-anyway", "--stats"}).exitCode == 1);
  CHECK(runCandela({"merge", scene}).exitCode == 1);
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
    CHECK(readFile(folder.path("a.png")) == readFile(folder.path("b.png")));
    CHECK(readFile(folder.path("a.hdr")) == readFile(folder.path("b.hdr")));
    CHECK(image::readImage(folder.path("b.exr")).rgb == image::readImage(film).rgb);
    const ProgramResult text = runCandela({"film", film});
    CHECK_THAT(text.out, Contains("holds") && Contains("samples 0:12 of crop 0,0,48,36") && Contains("cpu"));
    std::filesystem::remove(film);
  }
}

TEST_CASE("a film names every option that decides the image or how the scene is read, but no path") {
  const TemporaryFolder folder;
  const std::string film = folder.path("film.exr");
  kReference.film(folder.write("a.p3f", smallScene()), film);
  const json settings = json::parse(runCandela({"film", film, "--json", "-"}).out)["settings"];
  for (const char* name : {"integrator", "sampler", "max-depth", "one-sided", "lenient", "camera", "time"}) {
    CHECK(settings.contains(name));
  }
  CHECK_FALSE(settings.contains("allow-path"));
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

TEST_CASE("missing shards are named, and a partial merge says what is missing") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string a = folder.path("a.exr");
  const std::string c = folder.path("c.exr");
  kReference.film(scene, a, {"--samples", "0:4"});
  kReference.film(scene, c, {"--samples", "8:12", "--crop", "0,0,48,20"});
  const std::string merged = folder.path("merged.exr");
  const ProgramResult refused = runCandela({"merge", a, c, "-o", merged});
  CHECK(refused.exitCode == 2);
  CHECK_THAT(refused.err, Contains("samples 4:8 of crop 0,0,48,20") && Contains("samples 4:12 of crop 0,20,48,16") &&
                              Contains("are missing"));
  CHECK_FALSE(std::filesystem::exists(merged));
  const ProgramResult partial = runCandela({"merge", a, c, "-o", merged, "--partial", "--json", "-"});
  CHECK(partial.exitCode == 0);
  CHECK_THAT(partial.err, Contains("samples 4:12 of crop 0,20,48,16 are missing"));
  const json report = json::parse(partial.out);
  CHECK(report["complete"] == false);
  CHECK(report["missing"].size() == 2);
  CHECK(report["work"]["counts"]["samples"] == report["samples"]);
  CHECK_THAT(kReference.refusal(scene, {"--resume", merged}), Contains("gaps"));
}

TEST_CASE("a film that cannot be written in the end is an error, and the picture is still written") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string gone = folder.path("gone");
  std::filesystem::create_directory(gone);
  const std::string picture = folder.path("a.png");
  // The folder vanishes while the render runs.
  std::jthread thief([&] {
    std::this_thread::sleep_for(milliseconds(150));
    std::filesystem::remove(gone);
  });
  const ProgramResult result = kLong.run(scene,
                                         {"-o", picture, "--checkpoint", gone + "/a.exr", "--time-limit", "0.6s"});
  CHECK(result.exitCode == 2);
  CHECK_THAT(result.err, Contains("a.exr"));
  CHECK(std::filesystem::exists(picture));
}

TEST_CASE("a render that is stopped in any way leaves a film that it goes on from") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string whole = kLong.film(scene, folder.path("whole.exr"));
  const auto finish = [&](const std::string& film) { CHECK(kLong.film(scene, film, {"--resume", film}) == whole); };
  SECTION("by --time-limit") {
    const std::string film = folder.path("a.exr");
    const ProgramResult result = kLong.run(scene, {"--checkpoint", film, "--time-limit", "0.2s"});
    CHECK(result.exitCode == 7);
    CHECK_THAT(result.err, Contains("the time is up") && Contains("--resume " + film));
    const ProgramResult description = runCandela({"film", film});
    CHECK_THAT(description.out, Contains("interrupted in"));
    finish(film);
  }
  SECTION("by Ctrl-C and by SIGTERM") {
    for (const int signal : {SIGINT, SIGTERM}) {
      const std::string film = folder.path(std::to_string(signal) + ".exr");
      Surroundings surroundings;
      surroundings.interruptAfter = milliseconds(200);
      surroundings.signal = signal;
      CHECK(kLong.run(scene, {"--checkpoint", film}, surroundings).exitCode == 7);
      finish(film);
    }
  }
}

TEST_CASE("SIGUSR1 has the film written, again and again, and changes nothing") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string whole = kLong.film(scene, folder.path("whole.exr"));
  Surroundings surroundings;
  surroundings.writeRequestsFrom = milliseconds(100);
  surroundings.writeRequestsEvery = milliseconds(40);
  const std::string film = folder.path("a.exr");
  const ProgramResult result = kLong.run(scene, {"--checkpoint", film, "--checkpoint-every", "1h", "-v"}, surroundings);
  CHECK(result.exitCode == 0);
  CHECK(readFile(film) == whole);
  std::size_t writes = 0;
  for (std::size_t at = 0; (at = result.err.find("a.exr: written after", at)) != std::string::npos; ++at) ++writes;
  CHECK(writes >= 3);
  CHECK(folder.fileCount() == 5);  // the scene, and two films with their reports
}

TEST_CASE("a render that is killed at any moment goes on from its checkpoint, byte by byte") {
  requireSurvivesKills(kLong, 10, 1);
}

TEST_CASE("a render that is killed at 200 even and 100 random moments goes on from its checkpoint", "[slow]") {
  requireSurvivesKills(kLong, 200, 1);
  requireSurvivesKills(kLong, 0, 100);
}

}  // namespace candela

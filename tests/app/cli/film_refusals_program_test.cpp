// Films that are not resumed because the render differs, and --resume-anyway, on the reference tracer.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "host/image/image.h"
#include "tests/app/cli/film_runs.h"

namespace candela {
namespace {

using Catch::Contains;
using Catch::EndsWith;
using nlohmann::json;

}  // namespace

TEST_CASE("films whose samples depend on --spp are not resumed with another") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string strata = folder.path("strata.exr");
  kReference.film(scene, strata, {"--sampler", "stratified"});
  CHECK_THAT(kReference.refusal(scene, {"--sampler", "stratified", "--spp", "24", "--resume", strata}),
             Contains("started with 12 samples per pixel, and cannot be resumed with 24: the strata"));
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
  CHECK_THAT(refusal(other, {}),
             Contains("film.exr: the scene's hash is") &&
                 Contains("in this render: a file of the scene, its environment, its camera or the time of its "
                          "animation differs; --"));
  CHECK_THAT(refusal(scene, {"--seed", "1"}), Contains("--seed is 0 in the film and 1 in this render"));
  CHECK_THAT(refusal(scene, {"--filter", "gaussian"}), Contains("--filter is box in the film and gaussian:0.5 in"));
  CHECK_THAT(refusal(scene, {"--max-depth", "3"}), Contains("--max-depth is 64 in the film and 3"));
  CHECK_THAT(refusal(scene, {"--seed", "1", "--one-sided", "--time", "3"}),
             Contains("; use --seed 0, and leave out --one-sided and --time; --resume-anyway resumes nevertheless"));
  // Films do not record the values that films of older versions have.
  CHECK_THAT(refusal(scene, {"--lights", "tree", "--background", "none"}),
             Contains("; use --background env --lights power; --resume-anyway"));
  CHECK_THAT(refusal(scene, {"--size", "24x36"}), Contains("--size is 48x36") && EndsWith("; use --size 48x36\n"));
  CHECK_THAT(refusal(scene, {"--size", "24x36", "--resume-anyway"}),
             Contains("an image of 48x36 pixels, and the render of one of 24x36; use --size 48x36"));
  CHECK_THAT(refusal(scene, {"--spp", "0"}),
             Contains("film.exr: antialiasing is on in the film and off in this render; use --spp 12"));
  CHECK_THAT(refusal(scene, {"--integrator", "cost"}),
             Contains("--integrator is path in the film and cost in this render; use --integrator path; --resume"));
  CHECK_THAT(refusal(scene, {"--crop", "0,0,9,9"}), Contains("use --crop 0,0,48,36"));
  CHECK_THAT(refusal(scene, {"--samples", "5:8"}), Contains("starts at sample 0 and ends before sample 4"));
  CHECK_THAT(refusal(scene, {"--samples", "0:2"}), Contains("ends before sample 4"));
  CHECK_THAT(refusal(scene, {"--spp", "3"}),
             Contains("the film already has 4 samples per pixel; use --spp 5 or more") && Contains("`candela film`"));
  CHECK_THAT(refusal(folder.path("none.p3f"), {}), Contains("none.p3f"));
  const std::string later = folder.path("later.exr");
  kReference.film(scene, later, {"--samples", "4:8"});
  CHECK_THAT(
      kReference.refusal(scene, {"--resume", later}),
      Contains("starts at sample 4 and ends before sample 8, and the render has samples 0:12; use --samples 4:N"));
  CHECK_THAT(kReference.refusal(scene, {"--resume", folder.path("none.exr")}), Contains("none.exr: No such file"));
  CHECK_THAT(kReference.refusal(scene, {"--resume", scene}), Contains("not an OpenEXR file"));
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
               Contains("the film has the layers normal, and the render none; use --aov normal"));
  }
  const ProgramResult merged = runCandela({"merge", with, without, "-o", folder.path("merged.exr")});
  CHECK(merged.exitCode == 2);
  CHECK_THAT(merged.err, Contains("--aov is normal in") && Contains("and none in"));
  // Layers without sums make no difference.
  kReference.film(scene, folder.path("rest.exr"), {"--resume", with, "--aov", "normal,samples"});
}

TEST_CASE("a film that is resumed with other layers because of --denoise is refused with the option that helps") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string plain = folder.path("plain.exr"), moments = folder.path("moments.exr"),
                    all = folder.path("all.exr");
  kReference.film(scene, plain);
  kReference.film(scene, moments, {"--denoise"});
  kReference.film(scene, all, {"--aov", "normal"});
  const auto refusal = [&](const std::string& film, std::vector<std::string> options) {
    options.insert(options.end(), {"--resume", film, "-o", folder.path("a.exr")});
    return kReference.refusal(scene, options);
  };
  CHECK_THAT(refusal(plain, {"--denoise"}),
             Contains("and the render moments; use --aov none, and leave out --denoise\n"));
  CHECK_THAT(refusal(moments, {}), Contains("and the render none; use --denoise or --aov moments\n"));
  CHECK_THAT(refusal(all, {"--denoise"}), Contains("use --aov normal, and leave out --denoise\n"));
  CHECK_THAT(refusal(all, {}), Contains("use --aov normal\n"));
}

TEST_CASE("a film of the view cost is resumed only with its acceleration structure") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string film = folder.path("cost.exr");
  kReference.film(scene, film, {"--integrator", "cost", "--samples", "0:4"});
  CHECK_THAT(
      kReference.refusal(scene, {"--integrator", "cost", "--accel", "grid", "--resume", film}),
      Contains("cost.exr: the acceleration structure is none") && Contains("; use --accel none; --resume-anyway"));
  kReference.film(scene, folder.path("b.exr"), {"--integrator", "cost", "--accel", "none", "--resume", film});
}

TEST_CASE("a film is not resumed with fewer samples than some of its pixels have") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string film = folder.path("film.exr"), merged = folder.path("merged.exr");
  const ProgramResult stopped = kReference.run(
      scene, {"--checkpoint", film, "--crop", "0,0,24,36", "--spp", "100000", "--time-limit", "0.5s"});
  REQUIRE(stopped.exitCode == 7);
  CHECK_THAT(kReference.refusal(scene, {"--resume", film, "--crop", "0,0,24,36", "--spp", "2"}),
             Contains("film.exr: the film already has up to ") && Contains(" samples per pixel; use --spp "));
  const std::string right = folder.path("right.exr");
  kReference.film(scene, right, {"--crop", "24,0,24,36", "--spp", "100000", "--samples", "0:1"});
  REQUIRE(runCandela({"merge", film, right, "--partial", "-o", merged}).exitCode == 0);
  CHECK_THAT(kReference.refusal(scene, {"--resume", merged, "--spp", "100000"}),
             Contains("merged.exr: the film was merged with interrupted parts; resume the films of these parts"));
}

TEST_CASE("a film is resumed only under the same environment, whatever the name of its file") {
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

TEST_CASE("with --resume-anyway a film is resumed, and stays marked as mixed") {
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
  CHECK(description["mixed"] == true);
  CHECK(description["ignoredDifferences"] == json{"--seed is 0 in an earlier part and 1 in a later part"});
  CHECK(description["samples"] == 48 * 36 * 12);
}

}  // namespace candela

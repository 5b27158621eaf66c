// Films that are divided, resumed and merged as by a user, on the reference tracer.
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "host/image/image.h"
#include "tests/cli/film_runs.h"

namespace candela {
namespace {

using Catch::Contains;
using Catch::EndsWith;
using nlohmann::json;

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

TEST_CASE("a film that is resumed with more samples per pixel equals one with them from the start") {
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

TEST_CASE("films whose samples depend on --spp are not resumed with another") {
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
  CHECK_THAT(refusal(other, {}),
             Contains("film.exr: the scene's hash is") &&
                 Contains("in this render: a file of the scene, --env, --camera or --time differs; --"));
  CHECK_THAT(refusal(scene, {"--seed", "1"}), Contains("--seed is 0 in the film and 1 in this render"));
  CHECK_THAT(refusal(scene, {"--max-depth", "3"}), Contains("--max-depth is 64 in the film and 3"));
  CHECK_THAT(refusal(scene, {"--seed", "1", "--one-sided", "--time", "3"}),
             Contains("; use --seed 0, and leave out --one-sided and --time; --resume-anyway resumes nevertheless"));
  CHECK_THAT(refusal(scene, {"--size", "24x36"}), Contains("--size is 48x36") && EndsWith("; use --size 48x36\n"));
  CHECK_THAT(refusal(scene, {"--size", "24x36", "--resume-anyway"}),
             Contains("an image of 48x36 pixels, and the render of one of 24x36; use --size 48x36"));
  CHECK_THAT(refusal(scene, {"--spp", "0"}),
             Contains("film.exr: antialiasing is on in the film and off in this render; use --spp 12"));
  CHECK_THAT(refusal(scene, {"--integrator", "cost"}),
             Contains("--integrator is path in the film and cost in this render; leave out --integrator; --resume"));
  CHECK_THAT(refusal(scene, {"--crop", "0,0,9,9"}), Contains("use --crop 0,0,48,36"));
  CHECK_THAT(refusal(scene, {"--samples", "5:8"}), Contains("starts at sample 0 and ends before sample 4"));
  CHECK_THAT(refusal(scene, {"--samples", "0:2"}), Contains("ends before sample 4"));
  CHECK_THAT(refusal(scene, {"--spp", "3"}),
             Contains("the film already has 4 samples per pixel; use --spp 5 or more") && Contains("candela film "));
  CHECK_THAT(refusal(folder.path("none.p3f"), {}), Contains("none.p3f"));
  const std::string later = folder.path("later.exr");
  kReference.film(scene, later, {"--samples", "4:8"});
  CHECK_THAT(
      kReference.refusal(scene, {"--resume", later}),
      Contains("starts at sample 4 and ends before sample 8, and the render has samples 0:12; use --samples 4:N"));
  CHECK_THAT(kReference.refusal(scene, {"--resume", folder.path("none.exr")}), Contains("none.exr: No such file"));
  CHECK_THAT(kReference.refusal(scene, {"--resume", scene}), Contains("not an OpenEXR file"));
}

TEST_CASE("a film with a scale can be divided, and is continued and merged only with its scale") {
  const TemporaryFolder folder;
  requireEqualDivisions(kReference, folder, {"--film-scale", "5"});
  const std::string scene = folder.write("b.p3f", smallScene());
  const std::string film = folder.path("film.exr"), rest = folder.path("rest.exr");
  kReference.film(scene, film, {"--film-scale", "5", "--samples", "0:4"});
  CHECK_THAT(runCandela({"film", film}).out, Contains("--film-scale 5"));
  for (const char* accepted : {"--resume-anyway", "-q"}) {
    CHECK_THAT(kReference.refusal(scene, {"--resume", film, accepted}),
               Contains("film.exr: the film has the scale 5, and the render 0; use --film-scale 5"));
  }
  kReference.film(scene, rest, {"--samples", "4:12"});
  const ProgramResult merged = runCandela({"merge", film, rest, "-o", folder.path("all.exr")});
  CHECK(merged.exitCode == 2);
  CHECK_THAT(merged.err, Contains("--film-scale is 5 in") && Contains("absent in"));
}

TEST_CASE("the scale 0 leaves no trace in a film file, and the scale of strong lights is chosen by itself") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  CHECK(kReference.film(scene, folder.path("a.exr")) ==
        kReference.film(scene, folder.path("b.exr"), {"--film-scale", "0"}));
  const std::string strong = folder.write("c.p3f", smallScene("l 0 9 9 4e4 4e4 4e4\n"));
  const std::string json = folder.path("c.json");
  CHECK(kReference.film(strong, folder.path("c.exr"), {"--json", json}) ==
        kReference.film(strong, folder.path("d.exr"), {"--film-scale", "17"}));
  CHECK(jsonOf(json)["filmScale"] == 17);
  CHECK_THAT(runCandela({"check", strong}).out, Contains("film scale  2^17"));
  CHECK_THAT(runCandela({"check", scene}).out, !Contains("film scale"));
}

TEST_CASE("a film under an environment can be divided") {
  const TemporaryFolder folder;
  requireEqualDivisions(kReference, folder, {"--env", "sun:30,200,3"});
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
  CHECK_THAT(refusal(plain, {"--denoise"}), Contains("and the render moments; leave out --denoise\n"));
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

TEST_CASE("a film file is not overwritten by a render that does not resume it") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string film = folder.path("film.exr");
  const std::string before = kReference.film(scene, film);
  CHECK_THAT(kReference.refusal(scene, {"--checkpoint", film}), Contains("exists") && Contains("--resume " + film));
  CHECK(readText(film) == before);
  CHECK_THAT(kReference.refusal(scene, {"--checkpoint", "/dev/null"}), Contains("regular file"));
  CHECK_THAT(kReference.refusal(scene, {"--checkpoint", folder.path("no/where.exr")}), Contains("no folder"));
}

TEST_CASE("a film or report that could not be written is refused before anything is rendered") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string part = folder.path("part.exr"), picture = folder.path("a.png");
  kReference.film(scene, part);
  const auto refuse = [&](const std::string& film, int code, const std::string& message) {
    const ProgramResult rendered = kReference.run(scene, {"--checkpoint", film, "-o", picture});
    CHECK(rendered.exitCode == code);
    CHECK_THAT(rendered.err, Contains(message));
    CHECK(!std::filesystem::exists(picture));
    const ProgramResult merged = runCandela({"merge", part, "-o", film});
    CHECK(merged.exitCode == code);
    CHECK_THAT(merged.err, Contains(message));
  };
  // The name is short enough for a film, but not for the temporary file of its report.
  refuse(folder.path(std::string(240, 'n') + ".exr"), 2, "File name too long");
  std::filesystem::create_directory(folder.path("f.exr.json"));
  refuse(folder.path("f.exr"), 2, "f.exr.json: is a folder");
  refuse("-", 1, "-: a film is not written to stdout; name a file");
  refuse("/dev/null", 2, "/dev/null: a film is written to a regular file only");
  CHECK(folder.fileCount() == 4);  // the scene, a film with its report, and the folder
  const std::string spaced = folder.path("a b.exr");
  std::filesystem::copy_file(part, spaced);
  CHECK_THAT(kReference.refusal(scene, {"--checkpoint", spaced}), Contains("with --resume '" + spaced + "', or"));
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
  CHECK_THAT(kReference.run(scene, {"--samples", "0:1", "--spp", "4", "--stats"}).err,
             Contains("48x36 pixels, samples 0:1 of 4 per pixel, "));
  CHECK_THAT(kReference.run(scene, {"--spp", "1", "--stats"}).err, Contains("48x36 pixels, 1 sample per pixel, "));
  CHECK(runCandela({scene, "--checkpoint-every", "1s", "--stats"}).exitCode == 1);
  CHECK(runCandela({scene, "--resume-anyway", "--stats"}).exitCode == 1);
  CHECK(runCandela({"merge", scene}).exitCode == 1);
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

}  // namespace candela

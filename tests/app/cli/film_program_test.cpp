// Films that are divided, resumed and merged as by a user, on the reference tracer.
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/app/cli/film_runs.h"

namespace candela {
namespace {

using Catch::Contains;
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
                                             {"--filter", "gaussian:0.7"},
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

TEST_CASE("with --fallback cpu, a render that finds no device gives the film of the reference") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const auto film = [&](const std::string& name, const std::vector<std::string>& options) {
    std::vector<std::string> words{scene, "--spp", "4", "--checkpoint", folder.path(name)};
    words.insert(words.end(), options.begin(), options.end());
    const ProgramResult result = runCandela(
        words, {.environment = {"VK_DRIVER_FILES=/nonexistent", "VK_ICD_FILENAMES=/nonexistent"}});
    INFO(result.err);
    CHECK(result.exitCode == 0);
    CHECK(contains(result.err, "; the reference tracer finishes the render") == (options[0] != "--device"));
    return readText(folder.path(name));
  };
  CHECK(film("a.exr", {"--fallback", "cpu"}) == film("b.exr", {"--device", "cpu"}));
  CHECK(film("c.exr", {"--fallback", "cpu", "--device", "no such device"}) == film("d.exr", {"--device", "cpu"}));
}

}  // namespace candela

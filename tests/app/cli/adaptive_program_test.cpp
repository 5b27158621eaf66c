// Adaptive sampling as a user runs it, on the reference tracer.
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "host/image/image.h"
#include "tests/app/cli/adaptive_runs.h"

namespace candela {
namespace {

using Catch::Contains;
using nlohmann::json;
using std::chrono::milliseconds;

const FilmRuns kAdaptive{adaptiveOptions({"--device", "cpu", "--size", "72x68"})};

}  // namespace

TEST_CASE("adaptive: a film has the same bytes however it was interrupted, divided into crops and resumed") {
  const TemporaryFolder folder;
  requireEqualAdaptiveFilms(kAdaptive, folder, 6);
}

TEST_CASE("adaptive: renders that are killed at any moment resume to the bytes of one run") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", causticScene());
  const std::string whole = kAdaptive.film(scene, folder.path("whole.exr"));
  const std::string film = folder.path("killed.exr");
  for (int time = 50; time < 400; time += 70) {
    Surroundings surroundings;
    surroundings.interruptAfter = milliseconds(time);
    surroundings.signal = SIGKILL;
    surroundings.writeRequestsFrom = milliseconds(40);
    surroundings.writeRequestsEvery = milliseconds(10);
    std::filesystem::remove(film);
    kAdaptive.run(scene, {"--checkpoint", film}, surroundings);
    const bool exists = std::filesystem::exists(film);
    INFO("killed after " << time << " ms, film: " << exists);
    CHECK(kAdaptive.film(scene, film,
                         exists ? std::vector<std::string>{"--resume", film} : std::vector<std::string>{}) == whole);
  }
}

TEST_CASE("adaptive: a film that is resumed with more samples per pixel equals one with them from the start") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", causticScene());
  const std::string film = folder.path("a.exr");
  kAdaptive.film(scene, film, {"--spp", "50"});
  CHECK(kAdaptive.film(scene, film, {"--spp", "100", "--resume", film}) ==
        kAdaptive.film(scene, folder.path("whole.exr"), {"--spp", "100"}));
}

TEST_CASE("adaptive: options that exclude it are refused, and the message says what to do") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", causticScene());
  const auto message = [&](const std::vector<std::string>& options) {
    const ProgramResult result = kAdaptive.run(scene, options);
    CHECK(result.exitCode == 1);
    return result.err;
  };
  const std::string film = folder.path("a.exr");
  CHECK_THAT(message({"--checkpoint", film, "--samples", "0:32"}),
             Contains("a part of them; divide the image with --crop instead"));
  CHECK_THAT(message({"--checkpoint", film, "--crop", "0,0,40,68"}), Contains("multiple of 64 pixels"));
  CHECK_THAT(message({"--checkpoint", film, "--spp", "16"}), Contains("set --spp, the maximum, above 16"));
  CHECK_THAT(message({"--checkpoint", film, "--noise-threshold", "0.004", "--spp", "4096"}), Contains("8192"));
  CHECK_THAT(message({"--checkpoint", film, "--noise-threshold", "0"}), Contains("--noise-threshold"));
  for (const char* command : {"compare", "verify", "bench"}) {
    const ProgramResult result = runCandela({command, scene, "--noise-threshold", "0.1"});
    CHECK(result.exitCode == 1);
    CHECK_THAT(result.err, Contains("--noise-threshold"));
  }
}

TEST_CASE("adaptive: a film is resumed only with its threshold") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", causticScene());
  const std::string film = folder.path("a.exr");
  kAdaptive.film(scene, film);
  CHECK_THAT(kAdaptive.refusal(scene, {"--noise-threshold", "0.3", "--resume", film}),
             Contains("--noise-threshold is 0.2 in the film and 0.3 in this render"));
  CHECK_THAT(kAdaptive.refusal(scene, {"--noise-threshold", "off", "--resume", film}),
             Contains("--noise-threshold is 0.2 in the film and absent in this render"));
  const std::string crop = folder.path("b.exr");
  const std::string rest = folder.path("c.exr");
  kAdaptive.film(scene, crop, {"--crop", "0,0,64,68"});
  kAdaptive.film(scene, rest, {"--crop", "64,0,8,68", "--noise-threshold", "0.3"});
  const ProgramResult merged = runCandela({"merge", crop, rest, "-o", folder.path("m.exr")});
  CHECK(merged.exitCode == 2);
  CHECK_THAT(merged.err, Contains("--noise-threshold is 0.2 in") && Contains("0.3 in"));
}

TEST_CASE("adaptive: a film is not resumed with fewer samples than one of its pixels has") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", causticScene());
  const std::string film = folder.path("a.exr");
  const std::vector<std::string> options{"--checkpoint", film, "--noise-threshold", "0.05", "--spp", "1000000"};
  int most = 0;
  for (const char* limit :
       {"0.5s", "1s", "2s", "4s", "8s", "16s"}) {  // every pixel has 64 samples before others follow
    std::vector<std::string> words = options;
    words.insert(words.end(), {"--time-limit", limit});
    if (std::filesystem::exists(film)) words.insert(words.end(), {"--resume", film});
    REQUIRE(kAdaptive.run(scene, words).exitCode == 7);
    most = json::parse(runCandela({"film", film, "--json", "-"}).out).at("adaptive").at("maxSamples");
    if (most > 65) break;
  }
  REQUIRE(most > 65);
  const std::string count = std::to_string(most);
  CHECK_THAT(kAdaptive.refusal(scene, {"--resume", film, "--noise-threshold", "0.05", "--spp", "65"}),
             Contains("a.exr: the film already has up to " + count + " samples per pixel; use --spp " + count));
}

TEST_CASE("adaptive: reports, films and images state the numbers of samples") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", causticScene());
  const std::string film = folder.path("a.exr");
  const std::string picture = folder.path("b.exr");
  const ProgramResult result = kAdaptive.run(scene, {"--checkpoint", film, "-o", picture, "--json", "-", "--denoise"});
  REQUIRE(result.exitCode == 0);
  const auto report = nlohmann::json::parse(result.out)["adaptive"];
  CHECK(report["minSamples"] == 16);
  CHECK(report["maxSamples"] == 96);
  CHECK(report["savedFraction"].get<double>() == Approx(1 - report["meanSamples"].get<double>() / 96));
  CHECK(report["halfRegions"].contains("16"));
  CHECK(report["meanError"] > 0);
  CHECK(report["maxError"] >= report["meanError"]);
  const auto described = nlohmann::json::parse(runCandela({"film", film, "--json", "-"}).out);
  CHECK(described["adaptive"] == report);
  CHECK(described["complete"] == true);
  CHECK(described["settings"]["noiseThreshold"] == 0.2);
  CHECK_THAT(runCandela({"film", film}).out, Contains("16 to 96 samples per pixel"));
  const image::Image image = image::readImage(picture);
  CHECK_THAT(image.metadata.at("candela.bias"), Contains("--noise-threshold 0.2"));
  CHECK_THAT(runCandela({"compare", picture, picture, "--alpha", "0.01"}).err, Contains("biased on purpose"));
}

TEST_CASE("adaptive: with off, films do not change") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", causticScene());
  CHECK(kReference.film(scene, folder.path("a.exr"), {"--noise-threshold", "off"}) ==
        kReference.film(scene, folder.path("b.exr")));
}

}  // namespace candela

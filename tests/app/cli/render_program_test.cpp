// `candela render` as a user runs it, on the reference tracer.
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "host/image/image.h"
#include "tests/app/cli/run_program.h"
#include "tests/image/read_pixels8.h"

namespace candela {
namespace {

using nlohmann::json;

}  // namespace

TEST_CASE("a render writes all requested images, and PNG is EXR through the display transform") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string exr = folder.path("a.exr");
  const std::string png = folder.path("a.png");
  const ProgramResult result = runCandela(
      {scene, "-o", exr, "-o", png, "--device", "cpu", "--spp", "4", "--tonemap", "aces", "--exposure", "1"});
  INFO(result.err);
  REQUIRE(result.exitCode == 0);
  CHECK(result.out.empty());
  CHECK(contains(result.err, "16x12 pixels, 4 samples per pixel"));
  CHECK(folder.fileCount() == 3);

  const image::Image image = image::readImage(exr);
  const image::Pixels8 pixels = image::readPixels8(png);
  REQUIRE(image.width == 16);
  REQUIRE(image.height == 12);
  CHECK(pixels.rgb == toPixels8(image, {image::ToneMap::aces, 1}).rgb);
  CHECK(*std::max_element(pixels.rgb.begin(), pixels.rgb.end()) > 0);
}

TEST_CASE("an EXR file of a crop has the pixels of the crop in the frame of the full image") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string exr = folder.path("a.exr");
  const ProgramResult result = runCandela({scene, "-o", exr, "--device", "cpu", "--spp", "1", "--crop", "3,2,5,7"});
  INFO(result.err);
  REQUIRE(result.exitCode == 0);
  const image::Image image = image::readImage(exr);
  CHECK(boxText(windowOf(image)) == "3,2,5,7");
  CHECK(boxText(frameOf(image)) == "0,0,16,12");
}

TEST_CASE("an EXR file describes how it was rendered") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene("spp 3\n"));
  const std::string exr = folder.path("a.exr");
  REQUIRE(runCandela({scene, "-o", exr, "--device", "cpu", "--seed", "5", "--one-sided"}).exitCode == 0);
  const auto metadata = image::readImage(exr).metadata;
  CHECK(metadata.at("candela.scene") == "a.p3f");
  CHECK(metadata.at("candela.sceneHash").size() == 16);
  CHECK(metadata.at("candela.samplesPerPixel") == "3");
  CHECK(metadata.at("candela.seed") == "5");
  CHECK(metadata.at("candela.device") == "cpu");
  CHECK(metadata.count("candela.driver") == 1);
  CHECK(metadata.at("candela.version") == CANDELA_VERSION);
  CHECK(metadata.at("candela.settings") ==
        "--spp 3 --seed 5 --size 16x12 --max-depth 64 --rr-start 4 --integrator path --ao-distance auto --nee on "
        "--lights power --sampler sobol --filter box --lens disc --pixel-origin centre --light-size 0 --clamp-indirect "
        "off "
        "--background env --film-scale auto --noise-threshold off --one-sided");
}

TEST_CASE("the JSON report has every documented figure") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const ProgramResult result = runCandela({scene, "--json", "-", "--device", "cpu", "--spp", "2", "-q"});
  INFO(result.err);
  REQUIRE(result.exitCode == 0);
  CHECK(result.err.empty());
  const json report = json::parse(result.out);
  for (const char* key : {"msamplesPerSecond",
                          "mraysPerSecond",
                          "verticesPerSample",
                          "traversalSteps",
                          "workgroup",
                          "auto",
                          "structure",
                          "bvhSplit",
                          "bvhQuality",
                          "kernel",
                          "device",
                          "driver",
                          "truncated",
                          "badSamples",
                          "phaseSeconds",
                          "rays",
                          "dispatches",
                          "structureQuality",
                          "sceneHash",
                          "filmHash",
                          "settings",
                          "samples",
                          "tile",
                          "segmentsPerDispatch",
                          "threads",
                          "version",
                          "filmScale"}) {
    INFO(key);
    CHECK(report.contains(key));
  }
  for (const char* phase : {"parse", "build", "upload", "pipeline", "trace", "readBack", "write", "total"}) {
    INFO(phase);
    CHECK(report["phaseSeconds"].contains(phase));
  }
  for (const char* kind : {"camera", "bounce", "shadow"}) CHECK(report["rays"].contains(kind));
  for (const char* figure : {"count", "medianSeconds", "p99Seconds", "maxSeconds"})
    CHECK(report["dispatches"].contains(figure));
  CHECK(report["samples"] == 16 * 12 * 2);
  CHECK(report["rays"]["camera"] == 16 * 12 * 2);
  CHECK(report["rays"]["shadow"] > 0);
  CHECK(report["kernel"] == "reference");
  CHECK(report["truncated"] == 0);
  CHECK(report["badSamples"]["samples"] == 0);
}

TEST_CASE("notes name the options of devices that the reference tracer does not read") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string notes = runCandela({scene,   "--json",         "-",         "--device",
                                        "cpu",   "--kernel",       "wavefront", "--workgroup",
                                        "4x4",   "--layout",       "bvh2",      "--loads",
                                        "texel", "--bvh-quality",  "high",      "--segments-per-dispatch",
                                        "2",     "--hang-timeout", "9s",        "--fallback",
                                        "cpu",   "--tile",         "8x8",       "--threads",
                                        "1"})
                                .err;
  INFO(notes);
  for (const char* option : {"--loads", "--workgroup", "--segments-per-dispatch", "--hang-timeout", "--fallback"})
    CHECK(contains(notes, std::string(option) + " has no effect here; it applies to Vulkan devices\n"));
  CHECK(contains(notes, "--kernel has no effect here; it applies to Vulkan devices with --integrator path\n"));
  CHECK(contains(notes, "--layout has no effect here; it applies to Vulkan devices with --accel bvh\n"));
  CHECK(contains(notes, "--bvh-quality has no effect here"));
  CHECK_FALSE(contains(notes, "--tile"));
  CHECK_FALSE(contains(notes, "--threads"));
}

TEST_CASE("notes say that options of environments and displays have no effect here") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const auto notes = [&](const std::string& output, std::vector<std::string> options) {
    std::vector<std::string> words{scene, "-o", folder.path(output), "--device", "cpu", "--spp", "1"};
    words.insert(words.end(), options.begin(), options.end());
    const ProgramResult result = runCandela(words);
    REQUIRE(result.exitCode == 0);
    return result.err;
  };
  const std::string env = notes("a.png", {"--env-scale", "2", "--env-rotate", "9", "--exposure", "1"});
  CHECK(contains(env, "--env-scale has no effect here; it applies to the environment of --env"));
  CHECK(contains(env, "--env-rotate has no effect here"));
  CHECK_FALSE(contains(env, "--exposure"));
  const std::string linear = notes("a.exr",
                                   {"--tonemap", "agx", "--exposure", "1", "--env", "white", "--env-scale", "2"});
  CHECK(contains(linear, "--tonemap has no effect here; it applies to PNG and JPEG files"));
  CHECK(contains(linear, "--exposure has no effect here"));
  CHECK_FALSE(contains(linear, "--env-scale"));
  CHECK(contains(notes("a.jpg", {"--background", "none"}), "--background none: JPEG, HDR and PFM files have no alpha"));
  CHECK_FALSE(contains(notes("a.png", {"--background", "none"}), "alpha"));
}

TEST_CASE("the Whitted integrator reports rays by kind and options without effect") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene("l 0 0 9\n"));
  const ProgramResult result = runCandela(
      {scene, "--json", "-", "--device", "cpu", "--integrator", "whitted", "--nee", "off"});
  INFO(result.err);
  REQUIRE(result.exitCode == 0);
  CHECK(result.err.find("--nee has no effect here; it applies to --integrator path") != std::string::npos);
  const json report = json::parse(result.out);
  CHECK(report["settings"]["maxDepth"] == 4);
  CHECK(report["rays"]["cameraHits"] > 0);
  CHECK(report["rays"]["bounce"] == report["rays"]["reflected"].get<int>() + report["rays"]["refracted"].get<int>());
}

TEST_CASE("the film does not depend on threads and structure, but on the seed") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const auto filmHash = [&](const std::vector<std::string>& options) {
    std::vector<std::string> words{scene, "--json", "-", "--device", "cpu", "--spp", "2"};
    words.insert(words.end(), options.begin(), options.end());
    const ProgramResult result = runCandela(words);
    INFO(result.err);
    REQUIRE(result.exitCode == 0);
    return json::parse(result.out)["filmHash"].get<std::string>();
  };
  const std::string hash = filmHash({"-t", "1"});
  CHECK(filmHash({"-t", "2"}) == hash);
  CHECK(filmHash({"--accel", "none"}) == hash);
  CHECK(filmHash({"--accel", "grid", "--grid-density", "3"}) == hash);
  CHECK(filmHash({"--bvh-split", "midpoint"}) == hash);
  CHECK(filmHash({"--bvh-quality", "high"}) == hash);
  CHECK(filmHash({"--seed", "1"}) != hash);
}

TEST_CASE("the file's number of samples is used unless the command line states another") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene("spp 3\n"));
  const auto run = [&](std::vector<std::string> options) {
    std::vector<std::string> words{scene, "-v", "--json", "-", "--device", "cpu"};
    words.insert(words.end(), options.begin(), options.end());
    return runCandela(words);
  };
  const ProgramResult asked = run({});
  CHECK(json::parse(asked.out)["samples"] == 3 * 16 * 12);
  CHECK(contains(asked.err, "3 samples per pixel, as requested by the scene"));
  CHECK(json::parse(run({"--spp", "1"}).out)["samples"] == 1 * 16 * 12);
}

TEST_CASE("the option --quiet suppresses all output, and --stats prints a table") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const ProgramResult quiet = runCandela({scene, "-o", folder.path("a.png"), "--device", "cpu", "--spp", "1", "-q"});
  CHECK(quiet.exitCode == 0);
  CHECK(quiet.out.empty());
  CHECK(quiet.err.empty());
  const ProgramResult table = runCandela({scene, "--stats", "--device", "cpu", "--spp", "1"});
  CHECK(table.exitCode == 0);
  CHECK(contains(table.out, "\nmraysPerSecond "));
}

TEST_CASE("Ctrl-C writes the finished samples and exits with 7") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string exr = folder.path("a.exr");
  Surroundings surroundings;
  surroundings.interruptAfter = std::chrono::milliseconds(400);
  const ProgramResult result = runCandela({scene, "-o", exr, "--device", "cpu", "--size", "512x384", "--spp", "5000"},
                                          surroundings);
  INFO(result.err);
  CHECK(result.exitCode == 7);
  CHECK(contains(result.err, "interrupted"));
  const image::Image image = image::readImage(exr);
  CHECK(image.width == 512);
  CHECK(image.metadata.at("candela.interrupted") == "yes");
}

TEST_CASE("help and version go to stdout and exit with 0, wrong usage exits with 1") {
  const ProgramResult help = runCandela({"--help"});
  CHECK(help.exitCode == 0);
  CHECK(contains(help.out, "--segments-per-dispatch"));
  CHECK(runCandela({"--version"}).out == "candela " CANDELA_VERSION "\n");
  const ProgramResult wrong = runCandela({"a.p3f", "--sp", "4"});
  CHECK(wrong.exitCode == 1);
  CHECK(wrong.err == "candela: unknown option --sp; did you mean --spp?\ncandela: see candela render --help\n");
  CHECK(runCandela({}).exitCode == 1);
}

}  // namespace candela

// Requests of a file against options of the command line.
#include "host/cli/render_job.h"

#include <catch2/catch.hpp>
#include <sstream>

#include "host/cli/bad_samples.h"

namespace candela::cli {
namespace {

Scene sceneWithCamera() {
  Scene scene;
  scene.camera = Camera{};
  scene.camera->width = 40;
  scene.camera->height = 30;
  return scene;
}

}  // namespace

TEST_CASE("the command line wins over the file, the file over the default") {
  std::ostringstream sink;
  const Log log(sink, Verbosity::verbose);
  Scene scene = sceneWithCamera();

  Arguments byDefault;
  resolveRequests(byDefault, scene, log);
  CHECK(byDefault.settings.sampleCount == 16);
  CHECK(byDefault.settings.accel == AccelKind::bvh);
  CHECK(byDefault.settings.size.width == 40);
  CHECK(byDefault.settings.size.height == 30);
  CHECK(sink.str().empty());

  scene.requestedSamples = 225;
  scene.requestedAccel = 0;
  Arguments byFile;
  resolveRequests(byFile, scene, log);
  CHECK(byFile.settings.sampleCount == 225);
  CHECK(byFile.settings.accel == AccelKind::none);
  CHECK(sink.str() == "candela: 225 samples per pixel in total, as the file asks\n");

  Arguments byOption;
  byOption.sampleCount = 3;
  byOption.accel = AccelKind::bvh;
  byOption.size = Extent{5, 6};
  resolveRequests(byOption, scene, log);
  CHECK(byOption.settings.sampleCount == 3);
  CHECK(byOption.settings.accel == AccelKind::bvh);
  CHECK(byOption.settings.size.height == 6);
}

TEST_CASE("the longest path is the integrator's unless the command line says") {
  std::ostringstream sink;
  const Log log(sink, Verbosity::normal);
  Arguments path;
  resolveRequests(path, sceneWithCamera(), log);
  CHECK(path.settings.maxDepth == 64);
  Arguments whitted;
  whitted.settings.integrator = Integrator::whitted;
  resolveRequests(whitted, sceneWithCamera(), log);
  CHECK(whitted.settings.maxDepth == 4);
  Arguments stated;
  stated.settings.integrator = Integrator::whitted;
  stated.maxDepth = 7;
  resolveRequests(stated, sceneWithCamera(), log);
  CHECK(stated.settings.maxDepth == 7);
}

TEST_CASE("a file may ask for each of the structures") {
  std::ostringstream sink;
  Scene scene = sceneWithCamera();
  for (const auto& [number, accel] : {std::pair(0u, AccelKind::none), {1u, AccelKind::grid}, {2u, AccelKind::bvh}}) {
    scene.requestedAccel = number;
    Arguments arguments;
    resolveRequests(arguments, scene, Log(sink, Verbosity::normal));
    CHECK(arguments.settings.accel == accel);
  }
  CHECK(sink.str().empty());
}

TEST_CASE("bad samples are told with the command that replays the first of a pixel") {
  RenderJob job;
  job.arguments.files = {"a scene.p3f"};
  job.arguments.sampleCount = 64;
  job.arguments.settings.seed = 9;
  Film film(3, 2);
  CHECK(badSampleReport(film, job).empty());

  FilmPixel& pixel = film.at(2, 1);
  pixel.badCount = 2;
  pixel.firstBadSample = 6;  // 1 + index
  const std::vector<std::string> lines = badSampleReport(film, job);
  REQUIRE(lines.size() == 2);
  CHECK(lines[0] == "2 samples in 1 pixels were not finite (they count as 0) or too bright (they are clamped)");
  CHECK(lines[1] ==
        "pixel (2, 1): 2 bad, the first is sample 5; replay: candela render 'a scene.p3f' --spp 6 --seed 9 -o "
        "replay.exr");

  // A single sample of Whitted's would not be jittered.
  pixel.firstBadSample = 1;
  job.arguments.settings.integrator = job.settings.integrator = Integrator::whitted;
  job.settings.sampleCount = 64;
  CHECK(badSampleReport(film, job)[1].find("--spp 2 --seed 9 --integrator whitted") != std::string::npos);
  job.arguments.settings.integrator = job.settings.integrator = Integrator::path;

  job.arguments.settings.sampler = job.settings.sampler = SamplerKind::stratified;
  CHECK(badSampleReport(film, job)[1].find("--spp 64 --seed 9 --sampler stratified") != std::string::npos);
}

}  // namespace candela::cli

// Requests of a file against options of the command line.
#include "host/cli/render_job.h"

#include <catch2/catch.hpp>
#include <sstream>

namespace candela::cli {
namespace {

scene::Scene sceneWithCamera() {
  scene::Scene scene;
  scene.camera = scene::Camera{};
  scene.camera->width = 40;
  scene.camera->height = 30;
  return scene;
}

}  // namespace

TEST_CASE("the command line wins over the file, the file over the default") {
  std::ostringstream sink;
  const Log log(sink, Verbosity::verbose);
  scene::Scene scene = sceneWithCamera();

  Arguments byDefault;
  resolveRequests(byDefault, scene, log);
  CHECK(byDefault.settings.sampleCount == 16);
  CHECK(byDefault.settings.accel == render::AccelKind::bvh);
  CHECK(byDefault.settings.size.width == 40);
  CHECK(byDefault.settings.size.height == 30);
  CHECK(sink.str().empty());

  scene.requestedSamples = 225;
  scene.requestedAccel = 0;
  Arguments byFile;
  resolveRequests(byFile, scene, log);
  CHECK(byFile.settings.sampleCount == 225);
  CHECK(byFile.settings.accel == render::AccelKind::none);
  CHECK(sink.str() == "candela: 225 samples per pixel, as requested by the scene\n");

  Arguments byOption;
  byOption.sampleCount = 3;
  byOption.accel = render::AccelKind::bvh;
  byOption.size = render::Extent{5, 6};
  resolveRequests(byOption, scene, log);
  CHECK(byOption.settings.sampleCount == 3);
  CHECK(byOption.settings.accel == render::AccelKind::bvh);
  CHECK(byOption.settings.size.height == 6);
}

TEST_CASE("the maximum depth is that of the integrator unless the command line states it") {
  std::ostringstream sink;
  const Log log(sink, Verbosity::normal);
  Arguments path;
  resolveRequests(path, sceneWithCamera(), log);
  CHECK(path.settings.maxDepth == 64);
  Arguments whitted;
  whitted.settings.integrator = render::Integrator::whitted;
  resolveRequests(whitted, sceneWithCamera(), log);
  CHECK(whitted.settings.maxDepth == 4);
  Arguments stated;
  stated.settings.integrator = render::Integrator::whitted;
  stated.maxDepth = 7;
  resolveRequests(stated, sceneWithCamera(), log);
  CHECK(stated.settings.maxDepth == 7);
}

TEST_CASE("a file may ask for each of the structures") {
  std::ostringstream sink;
  scene::Scene scene = sceneWithCamera();
  for (const auto& [number, accel] :
       {std::pair(0u, render::AccelKind::none), {1u, render::AccelKind::grid}, {2u, render::AccelKind::bvh}}) {
    scene.requestedAccel = number;
    Arguments arguments;
    resolveRequests(arguments, scene, Log(sink, Verbosity::normal));
    CHECK(arguments.settings.accel == accel);
  }
  CHECK(sink.str().empty());
}

}  // namespace candela::cli

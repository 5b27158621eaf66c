// Precedence of the requests of a file and the options of the command line.
#include "host/app/cli/render_job.h"

#include <catch2/catch.hpp>
#include <sstream>
#include <type_traits>

#include "host/app/cli/render_images.h"
#include "host/app/view/camera_text.h"

namespace candela::cli {
namespace {

scene::Scene sceneWithCamera() {
  scene::Scene scene;
  scene.camera = scene::Camera{};
  scene.camera->width = 40;
  scene.camera->height = 30;
  return scene;
}

std::shared_ptr<const scene::Scene> shared(const scene::Scene& scene) {
  return std::make_shared<const scene::Scene>(scene);
}

// A caller cannot write settings that ignore what the scene requests.
static_assert(!std::is_default_constructible_v<render::RenderSettings>);
static_assert(!std::is_constructible_v<render::RenderSettings, render::RenderRequest>);

}  // namespace

TEST_CASE("the command line takes precedence over the file, and the file over the default") {
  std::ostringstream sink;
  const Log log(sink, Verbosity::verbose);
  scene::Scene scene = sceneWithCamera();

  RenderArguments byDefault;
  const render::RenderSettings byDefaultSettings = jobOf(byDefault, shared(scene), log).settings;
  CHECK(byDefaultSettings.image.sampleCount == 16);
  CHECK(byDefaultSettings.structure.accel == render::AccelKind::bvh);
  CHECK(byDefaultSettings.image.size.width == 40);
  CHECK(byDefaultSettings.image.size.height == 30);
  CHECK(sink.str().empty());

  scene.requestedSamples = 225;
  scene.requestedAccel = scene::RequestedAccel::none;
  RenderArguments byFile;
  const render::RenderSettings byFileSettings = jobOf(byFile, shared(scene), log).settings;
  CHECK(byFileSettings.image.sampleCount == 225);
  CHECK(byFileSettings.structure.accel == render::AccelKind::none);
  CHECK(sink.str() == "candela: 225 samples per pixel, as requested by the scene\n");

  RenderArguments byOption;
  byOption.request.sampleCount = 3;
  byOption.request.accel = render::AccelKind::bvh;
  byOption.request.size = render::Extent{5, 6};
  const render::RenderSettings byOptionSettings = jobOf(byOption, shared(scene), log).settings;
  CHECK(byOptionSettings.image.sampleCount == 3);
  CHECK(byOptionSettings.structure.accel == render::AccelKind::bvh);
  CHECK(byOptionSettings.image.size.height == 6);
}

TEST_CASE("0 samples per pixel mean one ray through each pixel's origin") {
  std::ostringstream sink;
  scene::Scene scene = sceneWithCamera();
  scene.requestedSamples = 0;
  RenderArguments byFile;
  const render::RenderSettings byFileSettings = jobOf(byFile, shared(scene), Log(sink, Verbosity::normal)).settings;
  CHECK(byFileSettings.image.sampleCount == 1);
  CHECK_FALSE(byFileSettings.image.jittersPixels());
  CHECK_FALSE(byFileSettings.image.antialiasing);
  CHECK(render::requestOf(byFileSettings).sampleCount == 0u);
  RenderArguments byOption;
  byOption.request.sampleCount = 1;
  const render::RenderSettings byOptionSettings = jobOf(byOption, shared(scene), Log(sink, Verbosity::normal)).settings;
  CHECK(byOptionSettings.image.jittersPixels());
}

TEST_CASE("a structure that only the scene requests is a preference") {
  std::ostringstream sink;
  scene::Scene scene = sceneWithCamera();
  scene.requestedAccel = scene::RequestedAccel::none;
  RenderArguments byFile;
  const render::RenderSettings byFileSettings = jobOf(byFile, shared(scene), Log(sink, Verbosity::normal)).settings;
  CHECK(byFileSettings.structure.accelIsPreference);
  RenderArguments byOption;
  byOption.request.accel = render::AccelKind::none;
  const render::RenderSettings byOptionSettings = jobOf(byOption, shared(scene), Log(sink, Verbosity::normal)).settings;
  CHECK_FALSE(byOptionSettings.structure.accelIsPreference);
}

TEST_CASE("the maximum depth is that of the integrator unless the command line states it") {
  std::ostringstream sink;
  const Log log(sink, Verbosity::normal);
  RenderArguments path;
  const render::RenderSettings pathSettings = jobOf(path, shared(sceneWithCamera()), log).settings;
  CHECK(pathSettings.image.maxDepth == 64);
  RenderArguments whitted;
  whitted.request.image.integrator = render::Integrator::whitted;
  const render::RenderSettings whittedSettings = jobOf(whitted, shared(sceneWithCamera()), log).settings;
  CHECK(whittedSettings.image.maxDepth == 4);
  RenderArguments stated;
  stated.request.image.integrator = render::Integrator::whitted;
  stated.request.maxDepth = 7;
  const render::RenderSettings statedSettings = jobOf(stated, shared(sceneWithCamera()), log).settings;
  CHECK(statedSettings.image.maxDepth == 7);
}

TEST_CASE("a file can request the maximum depth of paths and the filter") {
  std::ostringstream sink;
  const Log log(sink, Verbosity::normal);
  scene::Scene scene = sceneWithCamera();
  scene.requestedMaxDepth = 9;
  scene.requestedFilter = scene::PixelFilter{scene::FilterKind::gaussian, 0.75f};
  const render::RenderSettings byFile = jobOf(RenderArguments(), shared(scene), log).settings;
  CHECK(byFile.image.maxDepth == 9);
  CHECK(byFile.image.filter == scene.requestedFilter);
  CHECK(render::requestOf(byFile).filter == scene.requestedFilter);
  RenderArguments stated;
  stated.request.maxDepth = 3;
  stated.request.filter = render::PixelFilter{render::FilterKind::box};
  const render::RenderSettings byOption = jobOf(stated, shared(scene), log).settings;
  CHECK(byOption.image.maxDepth == 3);
  CHECK(byOption.image.filter == stated.request.filter);
  RenderArguments whitted;
  whitted.request.image.integrator = render::Integrator::whitted;
  CHECK(jobOf(whitted, shared(sceneWithCamera()), log).settings.image.maxDepth == 4);
}

TEST_CASE("a file can request a crop, which --crop and --size replace, and which only renders have") {
  std::ostringstream sink;
  const Log log(sink, Verbosity::verbose);
  scene::Scene scene = sceneWithCamera();
  scene.requestedCrop = scene::Window{3, 2, 20, 10};
  const render::RenderSettings byFile = jobOf(RenderArguments(), shared(scene), log).settings;
  CHECK(byFile.image.window() == scene.requestedCrop);
  CHECK(sink.str() == "candela: the crop 3,2,20,10, as requested by the scene\n");
  CHECK(render::resolve(render::requestOf(byFile), sceneWithCamera()).image.window() == scene.requestedCrop);
  RenderArguments cropped;
  cropped.request.crop = render::Window{0, 0, 40, 30};
  CHECK(jobOf(cropped, shared(scene), log).settings.image.window() == render::windowOf({40, 30}));
  RenderArguments sized;
  sized.request.size = render::Extent{8, 6};
  CHECK(jobOf(sized, shared(scene), log).settings.image.window() == render::windowOf({8, 6}));
  CHECK(jobOf(VerifyArguments(), shared(scene), log).settings.image.window() == render::windowOf({40, 30}));
  const render::RenderSettings whole = jobOf(sized, shared(scene), log).settings;
  CHECK(render::resolve(render::requestOf(whole), scene).image.window() == render::windowOf({8, 6}));
}

TEST_CASE("images of a camera that is not the scene's name it") {
  scene::Camera camera;
  Metadata metadata;
  addMovedCamera(camera, camera, metadata);
  CHECK(metadata.empty());
  scene::Camera moved = camera;
  moved.from.x += 2;
  addMovedCamera(moved, camera, metadata);
  CHECK(metadata.at("candela.camera") == view::cameraText(moved));
}

TEST_CASE("a file can request each of the structures") {
  std::ostringstream sink;
  scene::Scene scene = sceneWithCamera();
  for (const auto& [requested, accel] : {std::pair(scene::RequestedAccel::none, render::AccelKind::none),
                                         {scene::RequestedAccel::grid, render::AccelKind::grid},
                                         {scene::RequestedAccel::bvh, render::AccelKind::bvh}}) {
    scene.requestedAccel = requested;
    RenderArguments arguments;
    const render::RenderSettings argumentsSettings = jobOf(arguments, shared(scene), Log(sink, Verbosity::normal))
                                                         .settings;
    CHECK(argumentsSettings.structure.accel == accel);
  }
  CHECK(sink.str().empty());
}

}  // namespace candela::cli

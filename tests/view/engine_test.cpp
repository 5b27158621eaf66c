// The worker of a viewer, with two reference tracers.
#include "host/view/engine.h"

#include <catch2/catch.hpp>
#include <chrono>
#include <stdexcept>

#include "host/core/errors.h"
#include "host/formats/load_scene.h"
#include "host/reference/reference_renderer.h"
#include "host/render/request.h"

using namespace candela;
using namespace candela::view;

namespace {

constexpr std::uint32_t kSamples = 4;
constexpr render::Extent kSize{24, 16};

std::shared_ptr<const scene::Scene> testScene() {
  static const auto scene = std::make_shared<const scene::Scene>(
      formats::loadScene(std::filesystem::path(CANDELA_SOURCE_DIR) / "scenes/cornell.p3f").scene);
  return scene;
}

render::RenderSettings settingsOf(const Choice& choice, std::uint32_t seed = 0) {
  render::RenderSettings settings;
  settings.image.size = kSize;
  settings.image.sampleCount = kSamples;
  settings.image.maxDepth = 4;
  settings.image.integrator = choice.integrator;
  settings.image.seed = seed;
  settings.execution.threads = 1;
  return settings;
}

Sessions sessionsOf(const Choice& choice, bool) {
  Sessions sessions;
  sessions.scene = testScene();
  sessions.settings = settingsOf(choice);
  sessions.referenceRenderer = reference::makeReferenceRenderer();
  sessions.reference = sessions.referenceRenderer->prepare(*sessions.scene, sessions.settings);
  return sessions;
}

// A second reference tracer replaces the device. `seed` makes it differ.
auto deviceWithSeed(std::uint32_t seed) {
  return [seed](const Choice& choice, Sessions& sessions) {
    sessions.deviceRenderer = reference::makeReferenceRenderer();
    sessions.device = sessions.deviceRenderer->prepare(*sessions.scene, settingsOf(choice, seed));
    sessions.deviceName = "device";
  };
}

EngineHooks testHooks(std::uint32_t seed = 0) {
  return {.load = sessionsOf,
          .addDevice = deviceWithSeed(seed),
          .showOnDevice = [](render::Session&, const render::Extent&) { return false; },
          .save = {},
          .wake = [] {}};
}

template <class Condition>
EngineView waitFor(const Engine& engine, Condition condition) {
  for (int i = 0; i < 3000; ++i) {
    EngineView view = engine.view();
    if (condition(view)) return view;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  throw std::runtime_error("the engine has not reached the state within 30 s");
}

auto finished(Side side) {
  return [side](const EngineView& view) { return view.sides[indexOf(side)].samples == kSamples; };
}

Picture expectedPicture(const scene::Camera& camera, const Choice& choice) {
  scene::Scene scene = *testScene();
  scene.camera = camera;
  Picture picture(kSize);
  show(reference::makeReferenceRenderer()->render(scene, settingsOf(choice), {}).film, picture);
  return picture;
}

class LostSession final : public render::Session {
 public:
  bool advance(render::SampleRange, const render::RenderControl&) override {
    throw DeviceLostError("the device was lost");
  }
  image::Film film() override { return {}; }
  void reset(std::uint32_t) override {}
  void setCamera(const scene::Camera&) override {}
  void setView(const scene::Camera&, const render::Extent&) override {}
  void load(const image::Film&, std::uint32_t) override {}
  render::RenderStatistics statistics() override { return {}; }
  render::PathRecords paths() override { return {}; }
  render::Replay replay(const render::PixelSample&) override { return {}; }
};

// Waits until the engine publishes nothing for some time, and returns the serial number of its last view.
std::uint64_t settledSerial(const Engine& engine) {
  std::uint64_t serial = 0;
  while (engine.view().serial != serial) {
    serial = engine.view().serial;
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
  }
  return serial;
}

}  // namespace

TEST_CASE("the engine finishes the device's picture, and follows the camera") {
  const Choice choice{"0"};
  Engine engine(testHooks(), choice, Mode::device);
  const EngineView first = waitFor(engine, finished(Side::device));
  CHECK(first.deviceName == "device");
  CHECK(first.sides[0].picture->pixels == expectedPicture(*testScene()->camera, choice).pixels);

  scene::Camera camera = *testScene()->camera;
  camera.from.x += 0.25f;
  const std::uint64_t serial = engine.setCamera(camera);
  const EngineView moved = waitFor(
      engine, [&](const EngineView& view) { return view.viewSerial == serial && finished(Side::device)(view); });
  CHECK(moved.sides[0].picture->pixels == expectedPicture(camera, choice).pixels);
}

TEST_CASE("without a device, the reference is shown") {
  const Choice choice{"cpu", render::Integrator::normal};
  Engine engine(testHooks(), choice, Mode::device);
  const EngineView view = waitFor(engine, finished(Side::reference));
  CHECK(!view.sides[0].hasSession);
  CHECK(view.sides[1].picture->pixels == expectedPicture(*testScene()->camera, choice).pixels);
}

TEST_CASE("until the device is ready, the reference gives a preview") {
  std::promise<void> mayCompile;
  EngineHooks hooks = testHooks();
  hooks.addDevice = [&](const Choice& choice, Sessions& sessions) {
    mayCompile.get_future().wait();
    deviceWithSeed(0)(choice, sessions);
  };
  Engine engine(hooks, {"0"}, Mode::device);
  const EngineView preview = waitFor(engine, finished(Side::reference));
  CHECK(preview.isPreparing);
  CHECK(preview.sides[0].scale == 0);
  mayCompile.set_value();
  CHECK(!waitFor(engine, finished(Side::device)).isPreparing);
}

TEST_CASE("both sides are compared at equal numbers of samples") {
  const auto compared = [](const EngineView& view) {
    return view.difference.has_value() && finished(Side::reference)(view);
  };
  SECTION("equal tracers") {
    Engine engine(testHooks(), {"0"}, Mode::split);
    const PictureDifference difference = *waitFor(engine, compared).difference;
    CHECK(difference.pixels == kSize.width * kSize.height);
    CHECK(difference.unequal == 0);
  }
  SECTION("other random numbers") {
    Engine engine(testHooks(7), {"0"}, Mode::difference);
    CHECK(waitFor(engine, compared).difference->unequal > 100);
  }
}

TEST_CASE("a pixel is explained, also by the sample that differs most") {
  Engine engine(testHooks(7), {"0"}, Mode::split);
  waitFor(engine, finished(Side::reference));
  const auto explains = [](std::uint32_t pixel) {
    return [pixel](const EngineView& view) { return !view.explanation.empty() && view.explained.x == pixel; };
  };
  engine.explain({3, 4, 2}, false);
  CHECK(waitFor(engine, explains(3)).explanation.find("pixel 3,4, sample 2") != std::string::npos);
  engine.explain({5, 4, 0}, true);
  CHECK(waitFor(engine, explains(5)).explanation.find("First difference") != std::string::npos);
}

TEST_CASE("a choice replaces the sessions, and a file that cannot be read does not") {
  EngineHooks hooks = testHooks();
  hooks.load = [](const Choice& choice, bool reads) {
    if (reads) throw FileError("the scene is broken");
    return sessionsOf(choice, reads);
  };
  Engine engine(hooks, {"0"}, Mode::device);
  engine.setChoice({"0", render::Integrator::albedo});
  const auto isAlbedo = [](const EngineView& view) {
    return view.choice.integrator == render::Integrator::albedo && finished(Side::device)(view);
  };
  const EngineView before = waitFor(engine, isAlbedo);
  engine.reload();
  const EngineView after = waitFor(engine, [](const EngineView& view) { return view.isError; });
  CHECK(after.message == "the scene is broken");
  CHECK(after.sides[0].picture == before.sides[0].picture);
}

TEST_CASE("the film that is saved has the samples that are shown") {
  std::promise<std::uint32_t> saved;
  EngineHooks hooks = testHooks();
  hooks.save = [&](const auto& file, const Sessions&, const image::Film& film,
                   const render::RenderStatistics& statistics, const Choice&, const image::DisplayTransform& display) {
    CHECK(file == "a.exr");
    CHECK(display.exposure == 2);
    CHECK(statistics.samples == std::uint64_t{kSamples} * kSize.width * kSize.height);
    saved.set_value(film.at(0, 0).sampleCount);
  };
  Engine engine(hooks, {"0"}, Mode::device);
  waitFor(engine, finished(Side::device));
  engine.save("a.exr", {.exposure = 2});
  CHECK(saved.get_future().get() == kSamples);
  CHECK(waitFor(engine, [](const EngineView& view) { return !view.message.empty(); }).message ==
        "a.exr: 4 samples per pixel");
}

TEST_CASE("the reference continues when the device is lost") {
  EngineHooks hooks = testHooks();
  hooks.addDevice = [](const Choice&, Sessions& sessions) { sessions.device = std::make_unique<LostSession>(); };
  Engine engine(hooks, {"0"}, Mode::device);
  const EngineView view = waitFor(
      engine, [](const EngineView& each) { return each.isError && finished(Side::reference)(each); });
  CHECK(view.message == "the device was lost; the reference continues");
  CHECK(!view.sides[0].hasSession);
}

TEST_CASE("a paused engine gives each view its first sample, and no more") {
  Engine engine(testHooks(), {"cpu"}, Mode::reference);
  waitFor(engine, finished(Side::reference));
  engine.setMode(Mode::reference, true);
  scene::Camera camera = *testScene()->camera;
  camera.from.x += 0.25f;
  const std::uint64_t moved = engine.setCamera(camera);
  waitFor(engine, [&](const EngineView& view) { return view.viewSerial == moved && view.sides[1].samples == 1; });
  settledSerial(engine);
  CHECK(engine.view().sides[1].samples == 1);
  CHECK(engine.view().sides[1].scale == 1);
  engine.setMode(Mode::reference, false);
  waitFor(engine, finished(Side::reference));
}

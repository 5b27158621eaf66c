// The worker of a viewer, with two reference tracers.
#include "host/app/view/engine.h"

#include <atomic>
#include <catch2/catch.hpp>

#include "engine_support.h"
#include "host/base/errors.h"

using namespace candela;
using namespace candela::view;

namespace {

class LostSession final : public render::Session {
 public:
  bool advance(render::SampleRange, const render::RenderControl&) override {
    throw DeviceLostError("the device was lost");
  }
  void restrictTo(const render::PixelMask&) override {}
  image::Film film() override { return {}; }
  void reset(std::uint32_t, std::uint32_t) override {}
  void setCamera(const scene::Camera&) override {}
  void setView(const scene::Camera&, const render::Extent&) override {}
  void load(const image::Film&, std::uint32_t) override {}
  render::RenderStatistics statistics() override { return {}; }
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

  const scene::Camera camera = movedCamera();
  const EngineView moved = moveTo(engine, camera, Side::device);
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

TEST_CASE("another time of the animation keeps the picture until the next one, and prepares the device at once") {
  EngineHooks hooks = testHooks();
  std::atomic<int> loads{0}, devices{0};
  hooks.load = [&](const Choice& choice, bool reads) {
    ++loads;
    Sessions sessions = sessionsOf(choice, reads);
    sessions.animationEnd = 2.0;
    return sessions;
  };
  hooks.addDevice = [&](const Choice& choice, Sessions& sessions) {
    ++devices;
    deviceWithSeed(choice.time ? 5 : 0)(choice, sessions);
  };
  Engine engine(hooks, {"0"}, Mode::device);
  const EngineView first = waitFor(engine, finished(Side::device));
  CHECK(first.animationEnd == 2.0);
  CHECK(showsTime(first, {"0"}, Mode::device));
  CHECK_FALSE(showsTime(first, {.device = "0", .time = 1}, Mode::device));
  bool wasPreparing = false, hadPicture = true;
  engine.setChoice({.device = "0", .time = 1});
  const EngineView second = waitFor(engine, [&](const EngineView& view) {
    wasPreparing = wasPreparing || view.isPreparing;
    hadPicture = hadPicture && view.sides[0].picture;
    return view.choice.time == 1.0 && finished(Side::device)(view);
  });
  CHECK_FALSE(wasPreparing);
  CHECK(hadPicture);
  CHECK(second.sides[0].picture->pixels != first.sides[0].picture->pixels);
  CHECK(loads == 2);
  CHECK(devices == 2);
}

TEST_CASE("a movement of the camera removes the picture of the side that does not follow it") {
  Engine engine(testHooks(7), {"0"}, Mode::split);
  waitFor(engine, finished(Side::reference));
  engine.setMode(Mode::device, false);
  const EngineView moved = moveTo(engine, movedCamera(), Side::device);
  CHECK(moved.sides[1].hasSession);
  CHECK(moved.sides[1].scale == 0);
  CHECK(moved.sides[1].samples == 0);
  CHECK(!moved.sides[1].picture);

  engine.setMode(Mode::reference, false);
  const EngineView reference = waitFor(engine, finished(Side::reference));
  CHECK(reference.sides[1].picture->pixels == expectedPicture(movedCamera(), {"0"}).pixels);
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
  const std::uint64_t moved = engine.setCamera(movedCamera());
  waitFor(engine, [&](const EngineView& view) { return view.viewSerial == moved && view.sides[1].samples == 1; });
  settledSerial(engine);
  CHECK(engine.view().sides[1].samples == 1);
  CHECK(engine.view().sides[1].scale == 1);
  engine.setMode(Mode::reference, false);
  waitFor(engine, finished(Side::reference));
}

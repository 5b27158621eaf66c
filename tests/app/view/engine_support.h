// Engines of two reference tracers, for tests of the viewer's worker.
#pragma once
#include <chrono>
#include <stdexcept>

#include "host/app/view/engine.h"
#include "host/formats/load_scene.h"
#include "host/trace/reference/reference_renderer.h"
#include "tests/trace/reference/default_settings.h"

namespace candela::view {

inline constexpr std::uint32_t kSamples = 4;
inline constexpr render::Extent kSize{24, 16};

inline std::shared_ptr<const scene::Scene> testScene() {
  static const auto scene = std::make_shared<const scene::Scene>(
      formats::loadScene(std::filesystem::path(CANDELA_SOURCE_DIR) / "scenes/cornell.p3f").scene);
  return scene;
}

inline render::RenderSettings settingsOf(const Choice& choice, std::uint32_t seed = 0) {
  render::RenderSettings settings = render::defaultSettings();
  settings.image.size = kSize;
  settings.image.sampleCount = kSamples;
  settings.image.maxDepth = 4;
  settings.image.integrator = choice.integrator;
  settings.image.layers = neededBy(choice.layer);
  settings.image.seed = seed;
  settings.execution.threads = 1;
  return settings;
}

inline Sessions sessionsOf(const Choice& choice, bool) {
  Sessions sessions{testScene(), settingsOf(choice)};
  sessions.reference = reference::makeReferenceRenderer()->prepare(*sessions.scene, sessions.settings);
  return sessions;
}

// A second reference tracer replaces the device. `seed` makes it differ.
inline auto deviceWithSeed(std::uint32_t seed) {
  return [seed](const Choice& choice, Sessions& sessions) {
    sessions.device = reference::makeReferenceRenderer()->prepare(*sessions.scene, settingsOf(choice, seed));
    sessions.deviceName = "device";
  };
}

inline EngineHooks testHooks(std::uint32_t seed = 0) {
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

inline auto finished(Side side) {
  return [side](const EngineView& view) { return view.sides[indexOf(side)].samples == kSamples; };
}

inline Picture expectedPicture(const scene::Camera& camera, const Choice& choice, std::uint32_t samples = kSamples) {
  scene::Scene scene = *testScene();
  scene.camera = camera;
  render::RenderSettings settings = settingsOf(choice);
  settings.image.sampleCount = samples;
  Picture picture(kSize);
  show(reference::makeReferenceRenderer()->render(scene, settings, {}).film, picture);
  return picture;
}

inline scene::Camera movedCamera() {
  scene::Camera camera = *testScene()->camera;
  camera.from.x += 0.25f;
  return camera;
}

// Returns the view in which the side has all samples of the camera.
inline EngineView moveTo(Engine& engine, const scene::Camera& camera, Side side) {
  const std::uint64_t serial = engine.setCamera(camera);
  return waitFor(engine, [&](const EngineView& view) { return view.viewSerial == serial && finished(side)(view); });
}

}  // namespace candela::view

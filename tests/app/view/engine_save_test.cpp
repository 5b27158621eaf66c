// Pictures that the viewer's worker saves.
#include <catch2/catch.hpp>

#include "engine_support.h"

using namespace candela;
using namespace candela::view;

namespace {

// Calls `act` once on the engine's thread, when it publishes a state that `condition` accepts.
class Intervention {
 public:
  Intervention(EngineHooks& hooks, std::function<bool(const EngineView&)> condition, std::function<void(Engine&)> act)
      : condition_(std::move(condition)), act_(std::move(act)) {
    hooks.wake = [this] { publish(); };
  }
  void start(Engine& engine) { engine_.set_value(&engine); }

 private:
  void publish() {
    if (std::this_thread::get_id() == constructor_ || hasActed_) return;
    Engine& engine = *started_.get();
    if (!condition_(engine.view())) return;
    hasActed_ = true;
    act_(engine);
  }

  std::function<bool(const EngineView&)> condition_;
  std::function<void(Engine&)> act_;
  const std::thread::id constructor_ = std::this_thread::get_id();
  bool hasActed_ = false;
  std::promise<Engine*> engine_;
  std::shared_future<Engine*> started_ = engine_.get_future().share();
};

struct Saved {
  scene::Camera camera;
  Picture picture{{}};
  std::uint32_t samples;
};

// The film that is saved is passed to the promise.
auto savedTo(std::promise<Saved>& saved) {
  return [&saved](const auto&, const Sessions&, const scene::Camera& camera, const image::Film& film, const auto&,
                  const Choice&, const auto&) {
    Saved result{camera, Picture({film.width(), film.height()}), film.at(0, 0).sampleCount};
    show(film, result.picture);
    saved.set_value(std::move(result));
  };
}

}  // namespace

TEST_CASE("the film that is saved has the samples that are shown") {
  std::promise<std::uint32_t> saved;
  EngineHooks hooks = testHooks();
  hooks.save = [&](const auto& file, const Sessions&, const scene::Camera&, const image::Film& film,
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

TEST_CASE("the film that is saved has the layer that is shown") {
  std::promise<std::pair<image::LayerSet, Choice>> saved;
  EngineHooks hooks = testHooks();
  hooks.save = [&](const auto&, const Sessions&, const scene::Camera&, const image::Film& film, const auto&,
                   const Choice& choice, const auto&) {
    saved.set_value({film.layers(), choice});
  };
  const Choice choice{"0", render::Integrator::path, image::Layer::position};
  Engine engine(hooks, choice, Mode::device);
  waitFor(engine, finished(Side::device));
  engine.save("a.exr", {});
  CHECK(saved.get_future().get() == std::pair(neededBy(image::Layer::position), choice));
}

TEST_CASE("a picture that is saved right after a movement of the camera is that of the new view") {
  std::promise<Saved> promise;
  EngineHooks hooks = testHooks();
  Intervention intervention(hooks, finished(Side::device), [](Engine& engine) {
    engine.setCamera(movedCamera());
    engine.save("a.png", {});
  });
  hooks.save = savedTo(promise);
  Engine engine(hooks, {"0"}, Mode::device);
  intervention.start(engine);
  const Saved saved = promise.get_future().get();
  CHECK(saved.camera.from == movedCamera().from);
  REQUIRE(saved.samples > 0);
  CHECK(saved.picture.pixels == expectedPicture(movedCamera(), {"0"}, saved.samples).pixels);
}

TEST_CASE("a picture that is saved during a preview waits for a sample of each pixel") {
  std::promise<Saved> promise;
  EngineHooks hooks = testHooks();
  const auto isPreview = [](const EngineView& view) { return view.sides[0].scale > 1; };
  Intervention intervention(hooks, isPreview, [](Engine& engine) { engine.save("a.png", {}); });
  hooks.save = savedTo(promise);
  Engine engine(hooks, {"0"}, Mode::device);
  intervention.start(engine);
  const Saved saved = promise.get_future().get();
  CHECK(saved.picture.size == kSize);
  CHECK(saved.samples == 1);
  waitFor(engine, [](const EngineView& view) { return view.message == "a.png: 1 sample per pixel"; });
}

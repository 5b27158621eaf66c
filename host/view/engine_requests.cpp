// The members of the engine that belong to the window's thread.
#include "host/view/engine.h"

namespace candela::view {

EngineView Engine::view() const {
  const std::scoped_lock lock(mutex_);
  return published_;
}

std::uint64_t Engine::setCamera(const scene::Camera& camera) {
  std::uint64_t serial = 0;
  inbox_.post([&](Requests& requests) {
    requests.camera = camera;
    serial = ++requests.viewSerial;
  });
  return serial;
}

void Engine::setMode(Mode mode, bool isPaused) {
  inbox_.post([&](Requests& requests) { requests.mode = {mode, isPaused}; });
}

void Engine::setChoice(const Choice& choice) {
  inbox_.post([&](Requests& requests) { requests.load = choice; });
}

void Engine::reload() {
  const Choice current = view().choice;
  inbox_.post([&](Requests& requests) {
    if (!requests.load) requests.load = current;
    requests.reads = true;
  });
}

void Engine::save(const std::filesystem::path& file, const image::DisplayTransform& display) {
  inbox_.post([&](Requests& requests) { requests.save = {file, display}; });
}

void Engine::explain(const render::PixelSample& sample, bool searches) {
  inbox_.post([&](Requests& requests) {
    requests.sample = sample;
    requests.searches = searches;
  });
}

}  // namespace candela::view

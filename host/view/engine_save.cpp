// Saves the picture that the engine shows.
#include <fmt/format.h>

#include <utility>

#include "host/view/engine.h"

namespace candela::view {

void Engine::startSave(const SaveRequest& request) {
  pendingSave_ = request;
  finishSave();
  if (pendingSave_) say(request.file.string() + ": is written when each pixel has a sample", false);
}

// Until all pixels have a sample, the session's film is that of an earlier camera or of a preview.
void Engine::finishSave() {
  const Side side = mode_ == Mode::reference || !sessions_.device ? Side::reference : Side::device;
  if (!pendingSave_ || schedule_->scale(side) != 1) return;
  const SaveRequest request = *std::exchange(pendingSave_, std::nullopt);
  guarded([&] { saveNow(side, request); });
}

void Engine::saveNow(Side side, const SaveRequest& request) {
  render::Session& session = *sessions_.session(side);
  hooks_.save(request.file, sessions_, camera_, session.film(), session.statistics(), choice_, request.display);
  const std::uint32_t samples = schedule_->samples(side);
  say(fmt::format("{}: {} {} per pixel", request.file.string(), samples, samples == 1 ? "sample" : "samples"), false);
}

}  // namespace candela::view

// Rendering in one call, for callers that need no session.
#include "host/render/renderer.h"

namespace candela::render {

RenderResult Renderer::render(const scene::Scene& scene, const RenderSettings& settings, const RenderControl& control) {
  const std::unique_ptr<Session> session = prepare(scene, settings);
  RenderResult result;
  result.interrupted = !session->advance({0, settings.image.sampleCount}, control);
  result.film = session->film();
  result.paths = session->paths();
  result.statistics = session->statistics();
  return result;
}

Replay Renderer::replay(const scene::Scene& scene, const RenderSettings& settings, const PixelSample& sample) {
  return prepare(scene, settings)->replay(sample);
}

}  // namespace candela::render

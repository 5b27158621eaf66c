// Rendering in one call, for callers that need no session.
#include "host/render/renderer.h"

#include "host/core/errors.h"

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

Replica Session::replica(const PixelSample&, std::uint32_t) {
  throw UsageError("only the reference traces replicas of a sample");
}

}  // namespace candela::render

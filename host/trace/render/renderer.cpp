// Rendering in one call, for callers that need no session.
#include "host/trace/render/renderer.h"

#include "host/base/errors.h"

namespace candela::render {

RenderResult Renderer::render(const scene::Scene& scene, const RenderSettings& settings, const RenderControl& control) {
  const std::unique_ptr<Session> session = prepare(scene, settings);
  RenderResult result;
  result.interrupted = !session->advance({0, settings.image.sampleCount}, control);
  result.film = session->film();
  if (PathRecorder* const recorder = session->recorder()) result.paths = recorder->paths();
  result.statistics = session->statistics();
  return result;
}

Replay Renderer::replay(const scene::Scene& scene, const RenderSettings& settings, const PixelSample& sample) {
  const std::unique_ptr<Session> session = prepare(scene, settings);
  SampleReplayer* const replayer = session->replayer();
  if (replayer == nullptr) throw UsageError("only samples of the path tracer can be replayed");
  return replayer->replay(sample);
}

}  // namespace candela::render

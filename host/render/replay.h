// Tracers that can trace one sample again and tell how it came to its radiance.
#pragma once
#include "host/render/path_trace.h"
#include "host/render/renderer.h"

namespace candela::render {

struct Replay {
  PathTrace path;
  RenderStatistics statistics;  ///< device, driver, structure, and whether work was truncated
};

class ReplayingRenderer : public Renderer {
 public:
  /// Traces the sample that a render() with the same settings adds to the film, bit for bit. `settings.integrator` is
  /// Integrator::path; the pixel lies within the image. Throws as render() does.
  virtual Replay replay(const scene::Scene& scene, const RenderSettings& settings, const PixelSample& sample) = 0;
};

}  // namespace candela::render

// The one interface of both tracers: a scene and settings in, a session out.
#pragma once
#include <memory>

#include "host/render/session.h"

namespace candela::render {

struct RenderResult {
  image::Film film;
  RenderStatistics statistics;
  bool interrupted = false;  ///< stopped early by `RenderControl::stop`; the film holds the samples that were finished
  PathRecords paths;         ///< empty unless ExecutionSettings::recordPaths
};

class Renderer {
 public:
  virtual ~Renderer() = default;
  /// Makes everything that rendering `scene` takes. The scene, which has a camera, must outlive the session; the
  /// renderer need not. Throws NoDeviceError, DeviceLostError, OutOfMemoryError, FileError (a size beyond the device's
  /// limits) and UsageError (a workgroup or kernel that the device or the integrator does not have).
  virtual std::unique_ptr<Session> prepare(const scene::Scene& scene, const RenderSettings& settings) = 0;

  /// Renders the whole image in one go: prepares a session, adds all samples and takes its film.
  RenderResult render(const scene::Scene& scene, const RenderSettings& settings, const RenderControl& control);
  /// Prepares a session and traces one sample again: see Session::replay().
  Replay replay(const scene::Scene& scene, const RenderSettings& settings, const PixelSample& sample);
};

}  // namespace candela::render

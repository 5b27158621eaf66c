// The interface of both tracers. It turns a scene and settings into a session.
#pragma once
#include <memory>

#include "host/trace/render/session.h"

namespace candela::render {

struct RenderResult {
  image::Film film;
  RenderStatistics statistics;
  bool interrupted = false;  ///< stopped early by `RenderControl::stop`; the film contains the samples that were
                             ///< finished
  PathRecords paths;         ///< empty unless ExecutionSettings::recordPaths
};

class Renderer {
 public:
  virtual ~Renderer() = default;
  /// Prepares a session that renders `scene`. The scene, which must have a camera, must outlive the
  /// session; the renderer need not. Throws NoDeviceError, DeviceLostError, OutOfMemoryError, FileError (if the size
  /// exceeds the device's limits) and UsageError (if the device or the integrator does not support the workgroup or the
  /// kernel).
  virtual std::unique_ptr<Session> prepare(const scene::Scene& scene, const RenderSettings& settings) = 0;

  /// Renders the whole image: prepares a session, adds all samples and returns its film.
  RenderResult render(const scene::Scene& scene, const RenderSettings& settings, const RenderControl& control);
  /// Prepares a session and traces one sample: see SampleReplayer::replay(). Throws UsageError if the integrator is not
  /// Integrator::path.
  Replay replay(const scene::Scene& scene, const RenderSettings& settings, const PixelSample& sample);
};

}  // namespace candela::render

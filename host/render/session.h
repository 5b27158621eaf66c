// A scene that is ready to be rendered: search structure, buffers and pipelines are made once and kept.
#pragma once
#include <atomic>
#include <cstdint>
#include <functional>

#include "host/image/film.h"
#include "host/render/path_record.h"
#include "host/render/path_trace.h"
#include "host/render/statistics.h"
#include "host/scene/scene.h"

namespace candela::render {

/// Samples [first, end) of each pixel.
struct SampleRange {
  std::uint32_t first = 0;
  std::uint32_t end = 0;
};

/// How a caller watches and stops a session while it traces.
struct RenderControl {
  const std::atomic<bool>* stop = nullptr;  ///< polled between dispatches or tiles
  /// May be empty; called often, with the share of the range that is finished and the samples finished in it.
  std::function<void(double fraction, std::uint64_t samplesDone)> progress;
};

/// One sample, traced again.
struct Replay {
  PathTrace path;
  RenderStatistics statistics;  ///< device, driver, structure, and whether work was truncated
};

/// Renders one scene with fixed settings, in as many steps as the caller likes. The film is the same, bit for bit,
/// however the samples are split into ranges, and whether or not a range was stopped and taken up again.
///
/// Every member may throw DeviceLostError, OutOfMemoryError or InternalError; after DeviceLostError the session is of
/// no use.
class Session {
 public:
  virtual ~Session() = default;

  /// Adds the samples of `range` that a pixel does not have yet to the film. In each pixel the film holds consecutive
  /// samples: `range` starts at or before the first sample that is missing anywhere, unless the film is empty; its end
  /// is at most ImageSettings::sampleCount. Returns false if `control` stopped it; the film then holds the samples that
  /// were finished, and a later call with the same range completes them. Throws UsageError for any other range.
  virtual bool advance(SampleRange range, const RenderControl& control) = 0;
  /// The film so far.
  virtual image::Film film() = 0;
  /// Empties the film and starts over with other random numbers.
  virtual void reset(std::uint32_t seed) = 0;
  /// Empties the film and moves the eye; nothing but what depends on the camera is computed again. The image keeps its
  /// size; the film then equals that of a session prepared with this camera.
  virtual void setCamera(const scene::Camera& camera) = 0;
  /// Continues from a film of the same scene, settings and seed that holds samples first, first + 1, ... of each pixel,
  /// as many as its sampleCount says. Throws UsageError if its size differs or a pixel has more samples than there are.
  virtual void load(const image::Film& film, std::uint32_t first = 0) = 0;

  /// Counts and times since the session was prepared or reset; those of preparation stay.
  virtual RenderStatistics statistics() = 0;
  /// One record per pixel; empty unless ExecutionSettings::recordPaths.
  virtual PathRecords paths() = 0;
  /// Traces one sample again, which adds nothing to the film: the sample that advance() adds, bit for bit. The
  /// integrator is Integrator::path; the pixel lies within the image.
  virtual Replay replay(const PixelSample& sample) = 0;
};

}  // namespace candela::render

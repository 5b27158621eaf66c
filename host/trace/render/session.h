// A scene that is ready to be rendered. The acceleration structure, buffers and pipelines are created once and reused.
#pragma once
#include <atomic>
#include <cstdint>
#include <functional>

#include "host/image/film.h"
#include "host/scene/scene.h"
#include "host/trace/render/extent.h"
#include "host/trace/render/path_record.h"
#include "host/trace/render/pixel_mask.h"
#include "host/trace/render/replay.h"
#include "host/trace/render/replicas.h"
#include "host/trace/render/statistics.h"

namespace candela::render {

/// Samples [first, end) of each pixel.
struct SampleRange {
  std::uint32_t first = 0;
  std::uint32_t end = 0;

  bool operator==(const SampleRange&) const = default;
};

/// Functions by which a caller watches and stops a session while it traces.
struct RenderControl {
  const std::atomic<bool>* stop = nullptr;  ///< polled between dispatches or tiles
  /// May be empty. It is called often, with the fraction of the range that is finished and the number of samples
  /// finished in it.
  std::function<void(double fraction, std::uint64_t samplesDone)> progress;
};

/// The rest of a session whose device failed.
struct Salvage {
  image::Film film;             ///< as it was last on the host: whole samples only, as Session::load() takes them
  RenderStatistics statistics;  ///< without the counts that only the device had; `samples` are those of the film
};

/// Renders one scene with fixed settings, in any number of steps. The film is the same, bit for bit, however the
/// samples are split into ranges, and whether or not a range was stopped and continued.
/// Every member function but salvage() and those that return a part of the session may throw DeviceLostError,
/// OutOfMemoryError or InternalError. After one of them, the session can only be salvaged and destroyed.
class Session {
 public:
  virtual ~Session() = default;

  /// Adds those samples of `range` to the film that a pixel does not have yet. The samples of each pixel in the film
  /// are consecutive: `range` starts at or before the first sample that any pixel lacks, unless the film is empty; its
  /// end is at most ImageSettings::sampleCount. Returns false if `control` stopped it; the film then contains the
  /// samples that were finished, and a later call with the same range completes them. Throws UsageError for any other
  /// range.
  virtual bool advance(SampleRange range, const RenderControl& control) = 0;
  /// Restricts the following calls of advance() to the pixels of `mask`, which has an entry for each pixel of the film
  /// or is empty; all others keep the samples that they have. No call of advance() may be unfinished. Whatever empties
  /// or replaces the film lifts the restriction.
  virtual void restrictTo(const PixelMask& mask) = 0;
  /// Returns the film so far.
  virtual image::Film film() = 0;
  /// Empties the film and starts again with this seed and this total number of samples per pixel, >= 1. The film then
  /// equals that of a session prepared with them.
  virtual void reset(std::uint32_t seed, std::uint32_t sampleCount) = 0;
  /// Empties the film and moves the camera. Only what depends on the camera is computed again. The image size stays the
  /// same; the film then equals that of a session prepared with this camera.
  virtual void setCamera(const scene::Camera& camera) = 0;
  /// Empties the film, moves the camera and changes the size of the image, each side in [1, 65535]. The film then
  /// equals that of a session prepared with this camera and size. Throws UsageError if the session renders a crop.
  virtual void setView(const scene::Camera& camera, const Extent& size) = 0;
  /// Continues from a film of the same scene, settings and seed whose pixels each contain the samples first, first + 1,
  /// ..., sampleCount of them. Throws UsageError if its size or its layers differ, or if a pixel would have samples
  /// beyond ImageSettings::sampleCount.
  virtual void load(const image::Film& film, std::uint32_t first = 0) = 0;

  /// Returns counts and times since the session was prepared or reset. Those of the preparation are included.
  virtual RenderStatistics statistics() = 0;
  /// Returns the film as the last call of film() or statistics() returned it, or newer, without using the device. Its
  /// pixels hold consecutive samples from the first one on, but not all the same number. If truncated work may have
  /// reached it, the statistics say so. The session can only be destroyed afterwards.
  virtual Salvage salvage() { return {film(), statistics()}; }

  // Not every session can do the following. What is returned is a part of the session.
  /// Returns null if the integrator is not Integrator::path.
  virtual SampleReplayer* replayer() { return nullptr; }
  /// Returns null unless ExecutionSettings::recordPaths.
  virtual PathRecorder* recorder() { return nullptr; }
  /// Returns null unless the tracer is the reference and ExecutionSettings::replicas is above 0.
  virtual ReplicaSource* replicaSource() { return nullptr; }
};

}  // namespace candela::render

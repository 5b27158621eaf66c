// Adds samples to a film with several threads, each pixel by only one of them.
#pragma once
#include <atomic>
#include <cstdint>

#include "host/image/film.h"
#include "host/scene/object_names.h"
#include "host/trace/reference/pixel_tracer.h"
#include "host/trace/reference/rounding/replicas.h"
#include "host/trace/render/replicas.h"
#include "host/trace/render/session.h"

namespace candela::reference {

/// The destination of a job's samples.
struct JobOutput {
  image::Film& film;
  render::Window window;       ///< pixels of the image that the film has
  std::uint32_t firstSample;   ///< index of the first sample of each pixel in the film
  render::PathRecords& paths;  ///< one per pixel for sample 0; empty: none are recorded
  render::ReplicaRecords& replicas;
  const ReplicaTracer* replicaTracer;  ///< null: no replicas are traced
  std::uint32_t replicaCount;
  bool countsHits;                  ///< samples whose camera ray hits something are counted
  const scene::MatteIds* matteIds;  ///< null: ids are not counted
  const render::PixelMask& mask;    ///< pixels that get samples
};

/// Traces the samples up to `sampleEnd`, exclusive, that pixels lack. The arguments that are references must outlive
/// it.
class TileJob {
 public:
  TileJob(const PixelTracer& tracer, render::Extent tile, std::uint32_t sampleEnd, const render::RenderControl& control,
          JobOutput output);

  /// Runs on `threads` threads, including the calling one, or on fewer if the system permits no more. Only the calling
  /// thread reports progress, so that callbacks need not be thread-safe. An exception of a callback or of a thread,
  /// such as std::bad_alloc, stops the other threads and is rethrown.
  Counters run(std::uint32_t threads);
  bool wasInterrupted() const { return interrupted_; }

 private:
  bool isStopped() const { return control_.stop && control_.stop->load(std::memory_order_relaxed); }
  bool renderNextTile(Counters& shared);
  /// Both return false if the job was stopped before their last sample.
  bool renderTile(std::uint32_t left, std::uint32_t top, Counters& counters);
  bool renderPixel(std::uint32_t x, std::uint32_t y, Counters& counters);
  dvec3 traceSample(const render::PixelSample& sample, std::size_t pixel, Counters& counters, SampleOutputs outputs);
  void addIds(std::uint32_t x, std::uint32_t y, const image::LayerSample& sample);
  void reportProgress();

  const PixelTracer& tracer_;
  render::Extent tile_;
  std::uint32_t sampleEnd_;
  const render::RenderControl& control_;
  JobOutput output_;
  std::uint32_t tilesAcross_;
  std::uint64_t tileCount_;
  double totalSamples_;
  bool hasSums_;  ///< of layers
  std::atomic<std::uint64_t> nextTile_{0};
  std::atomic<std::uint64_t> samplesDone_{0};
  std::uint64_t samplesReported_ = 0;
  std::atomic<bool> interrupted_{false};
};

}  // namespace candela::reference

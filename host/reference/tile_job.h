// Adds samples to a film: threads over tiles, one writer per pixel.
#pragma once
#include <atomic>
#include <cstdint>

#include "host/image/film.h"
#include "host/reference/pixel_tracer.h"
#include "host/render/session.h"

namespace candela::reference {

/// Where the samples of a job go.
struct JobOutput {
  image::Film& film;
  std::uint32_t firstSample;   ///< index of the first sample that the film holds of each pixel
  render::PathRecords& paths;  ///< one per pixel for sample 0; empty: none are kept
};

/// Traces the samples up to `sampleEnd`, exclusive, that pixels lack. What it refers to must outlive it.
class TileJob {
 public:
  TileJob(const PixelTracer& tracer, render::Extent tile, std::uint32_t sampleEnd, const render::RenderControl& control,
          JobOutput output);

  /// Runs on `threads` threads, the calling one included, which alone reports progress, so that callbacks need not be
  /// thread-safe. What they throw stops the other threads.
  Counters run(std::uint32_t threads);
  bool wasInterrupted() const { return interrupted_; }

 private:
  bool isStopped() const { return control_.stop && control_.stop->load(std::memory_order_relaxed); }
  bool renderNextTile(Counters& shared);
  bool renderTile(std::uint32_t left, std::uint32_t top, Counters& counters);
  void renderPixel(std::uint32_t x, std::uint32_t y, Counters& counters);
  void reportProgress();

  const PixelTracer& tracer_;
  render::Extent tile_;
  std::uint32_t sampleEnd_;
  const render::RenderControl& control_;
  JobOutput output_;
  std::uint32_t tilesAcross_;
  std::uint64_t tileCount_;
  double totalSamples_;
  std::atomic<std::uint64_t> nextTile_{0};
  std::atomic<std::uint64_t> samplesDone_{0};
  std::uint64_t samplesReported_ = 0;
  std::atomic<bool> interrupted_{false};
};

}  // namespace candela::reference

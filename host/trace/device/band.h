// The part of an image whose path states and film are in device memory at a time, and the loop that finishes it.
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "host/image/film.h"
#include "host/trace/device/device_scene.h"
#include "host/trace/device/dispatch_planner.h"
#include "host/trace/device/kernel.h"
#include "host/trace/device/loop_budget.h"
#include "host/trace/device/sampled_region.h"
#include "host/trace/device/stall_watch.h"
#include "host/trace/render/session.h"
#include "host/trace/vulkan/binding_set.h"
#include "host/trace/vulkan/compute_pipeline.h"

namespace candela::device {

/// Buffers for one band. They are created once and used for one band of the image after the other.
class Band {
 public:
  /// `pipelines` are those of the kernel's modules, in their order.
  Band(vulkan::Device& device, const Kernel& kernel, std::vector<vulkan::ComputePipeline> pipelines,
       const DeviceScene& scene, const render::RenderSettings& settings, std::uint32_t maxHeight);

  /// Makes these rows the band. `film` contains their pixels, row by row, with consecutive samples from `firstSample`
  /// on, and `layers` the records of their layers; if `film` is empty, no pixel has a sample. Paths start with the
  /// first sample that their pixel lacks. Pixels of the film that `mask` does not select get no samples.
  void load(BandRows rows, std::span<const image::FilmPixel> film, std::span<const image::LayerRow> layers,
            std::uint32_t firstSample, const render::PixelMask& mask);
  /// Changes the width of the image, and returns the number of its rows that fit into the buffers. load() follows.
  std::uint32_t setWidth(std::uint32_t width);
  /// The film of the rows: FilmRows for each pixel, row by row, then the records of layers.
  const vulkan::Buffer& film() const { return film_; }
  /// The rows of the last call of load().
  BandRows rows() const { return rows_; }

  /// Sets other specialisations of the same kernel for the following dispatches.
  void setPipelines(std::vector<vulkan::ComputePipeline> pipelines) { pipelines_ = std::move(pipelines); }

  /// Traces one segment in one workgroup, so that drivers compile the kernel. Its duration is not limited.
  void warmUp(std::uint32_t sampleEnd, const LoopBudget& budget);
  /// Dispatches until every pixel has its samples up to `sampleEnd`, exclusive; `pixelsLeft` is the number of pixels
  /// that lack samples. Returns false if `control` stopped it. Calls `samplesFinished` with the number of samples that
  /// each dispatch finished. Throws DeviceLostError if paths no longer advance.
  bool finish(std::uint32_t sampleEnd, std::uint64_t pixelsLeft, const LoopBudget& budget,
              const render::RenderControl& control, render::RenderStatistics& statistics,
              const std::function<void(std::uint64_t)>& samplesFinished);

  /// Copies the band's film. `film` has as many pixels as the band.
  void readFilm(std::span<image::FilmPixel> film, std::span<image::LayerRow> layers) const;
  /// Returns the lists of the pixels' hits, kListedHits words each. The render must have mattes.
  std::vector<std::uint32_t> readHitLists() const;
  /// Returns RenderStatistics::truncated of all work since load() without using the device.
  std::uint64_t truncated() const { return truncatedBefore_ + counters().truncated; }
  /// Adds the counts of all work since load().
  void addCounts(render::RenderStatistics& statistics) const;
  void readRecords(render::PathRecords& paths) const;

 private:
  std::uint64_t pixels() const { return std::uint64_t{width_} * rows_.height; }
  double dispatch(const Rect& region, std::uint32_t segments, std::uint32_t sampleEnd, const LoopBudget& budget);
  void setFirstSamples(std::span<const image::FilmPixel> film, std::uint32_t firstSample,
                       const render::PixelMask& mask);
  void clearCounters();
  const gpu::Counters& counters() const;
  std::uint64_t takeFinishedSamples();
  std::uint64_t stateHash() const;
  void requireProgress(std::uint64_t samplesFinished);

  vulkan::Device& device_;
  Kernel kernel_;
  std::vector<vulkan::ComputePipeline> pipelines_;
  const render::RenderSettings& settings_;
  std::uint32_t width_;
  std::uint64_t maxPixels_;  ///< for which the buffers have room
  BandRows rows_;
  SampledRegion sampled_;
  std::uint32_t samplesSeen_ = 0;         ///< last value of the wrapping counter
  std::uint64_t samplesBefore_ = 0;       ///< sum of the sample indices at which load() started the pixels
  std::uint64_t truncatedBefore_ = 0;     ///< in ranges that are finished
  std::uint64_t volumeFaultsBefore_ = 0;  ///< in ranges that are finished
  /// Continues from one range to the next, with its measurements, so that every region is processed regularly.
  std::optional<DispatchPlanner> planner_;
  StallWatch stallWatch_;
  vulkan::Buffer states_;
  vulkan::Buffer film_;
  vulkan::Buffer results_;
  vulkan::Buffer counters_;  ///< copy of the header of results_, for the host
  vulkan::BindingSet bindings_;
};

}  // namespace candela::device

// The part of an image whose path states and film are in device memory at a time, and the loop that finishes it.
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "host/device/device_scene.h"
#include "host/device/governor.h"
#include "host/device/kernel.h"
#include "host/device/loop_budget.h"
#include "host/device/tile_cursor.h"
#include "host/image/film.h"
#include "host/render/session.h"
#include "host/vulkan/binding_set.h"
#include "host/vulkan/compute_pipeline.h"

namespace candela::device {

/// Rows first .. first + height - 1 of the image.
struct BandRows {
  std::uint32_t first = 0;
  std::uint32_t height = 0;
};

/// Height of the tallest band whose largest buffer has at most `maxBytes` and can be bound by the device, at least 1.
/// Throws FileError if one row of the image is too much.
std::uint32_t bandHeight(const vulkan::DeviceInfo& info, const Kernel& kernel, const render::RenderSettings& settings,
                         std::uint64_t maxBytes);

/// Buffers for one band, made once and used for each band of the image in turn.
class Band {
 public:
  /// `pipelines` are made of the kernel's modules, in that order.
  Band(vulkan::Device& device, const Kernel& kernel, std::vector<vulkan::ComputePipeline> pipelines,
       const DeviceScene& scene, const render::RenderSettings& settings, std::uint32_t maxHeight);

  /// Makes these rows the band. `film` has their pixels, row by row, with consecutive samples from `firstSample` on; it
  /// may be empty, then no pixel has a sample. Paths start with the first sample that their pixel lacks.
  void load(BandRows rows, std::span<const image::FilmPixel> film, std::uint32_t firstSample);
  /// The rows that load() was called with last.
  BandRows rows() const { return rows_; }

  /// Other specialisations of the same kernel, for the dispatches to come.
  void setPipelines(std::vector<vulkan::ComputePipeline> pipelines) { pipelines_ = std::move(pipelines); }

  /// One workgroup traces one segment, so that drivers compile the kernel; it may take as long as it likes.
  void warmUp(std::uint32_t sampleEnd, const LoopBudget& budget);
  /// Dispatches until every pixel has its samples up to `sampleEnd`, exclusive; `pixelsLeft` are the pixels that lack
  /// some. False if `control` stopped it. Calls `samplesFinished` with the number of samples that each dispatch
  /// finished.
  bool finish(std::uint32_t sampleEnd, std::uint64_t pixelsLeft, const LoopBudget& budget,
              const render::RenderControl& control, render::RenderStatistics& statistics,
              const std::function<void(std::uint64_t)>& samplesFinished);

  /// Copies the band's film, which has as many pixels as the band.
  void readFilm(std::span<image::FilmPixel> film) const;
  /// Adds the counts of all work since load().
  void addCounts(render::RenderStatistics& statistics) const;
  void readRecords(render::PathRecords& paths) const;

 private:
  std::uint64_t pixels() const { return std::uint64_t{width_} * rows_.height; }
  double dispatch(const Rect& region, std::uint32_t segments, std::uint32_t sampleEnd, const LoopBudget& budget);
  void setFirstSamples(std::span<const image::FilmPixel> film, std::uint32_t firstSample);
  void clearCounters();
  /// Offset of the path records in results_.
  std::uint64_t recordOffset() const;
  const gpu::Counters& counters() const;
  std::uint64_t takeFinishedSamples();

  vulkan::Device& device_;
  Kernel kernel_;
  std::vector<vulkan::ComputePipeline> pipelines_;
  const render::RenderSettings& settings_;
  std::uint32_t width_;
  BandRows rows_;
  std::uint32_t samplesSeen_ = 0;      ///< of the wrapping counter
  std::uint64_t samplesBefore_ = 0;    ///< sum of the sample indices at which load() started the pixels
  std::uint64_t truncatedBefore_ = 0;  ///< of ranges that are finished
  std::optional<TileCursor> cursor_;   ///< goes on from one range to the next, so that no tile is left out for long
  std::optional<Governor> governor_;   ///< keeps what it learned from one range to the next
  vulkan::Buffer states_;
  vulkan::Buffer film_;
  vulkan::Buffer results_;
  vulkan::Buffer counters_;  ///< copy of the head of results_, for the host
  vulkan::BindingSet bindings_;
};

}  // namespace candela::device

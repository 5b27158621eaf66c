// The part of an image whose path states and film are in device memory at a time, and the loop that finishes it.
#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "host/device/device_scene.h"
#include "host/device/governor.h"
#include "host/device/kernel.h"
#include "host/device/loop_budget.h"
#include "host/image/film.h"
#include "host/render/renderer.h"
#include "host/vulkan/binding_set.h"
#include "host/vulkan/compute_pipeline.h"

namespace candela::device {

/// Rows first .. first + height - 1 of the image.
struct BandRows {
  std::uint32_t first = 0;
  std::uint32_t height = 0;
};

/// Tallest band that the device can bind for an image of this width, at least 1. Throws FileError if one row is too
/// much.
std::uint32_t bandHeight(const vulkan::DeviceInfo& info, const Kernel& kernel, const render::RenderSettings& settings);

/// Buffers for one band, made once and used for each band in turn. `pipelines` are made of the kernel's modules, in
/// that order.
class Band {
 public:
  Band(vulkan::Device& device, const Kernel& kernel, const std::vector<const vulkan::ComputePipeline*>& pipelines,
       const DeviceScene& scene, const render::RenderSettings& settings, std::uint32_t maxHeight);

  /// Sets all paths and sums of the band to their beginning.
  void start(BandRows rows);
  /// One tiny dispatch, in which drivers compile.
  void warmUp(const LoopBudget& budget);
  /// Dispatches until every sample of the band is done or `control` says stop; adds times to `statistics`, and tells
  /// `samplesFinished` of new samples as they come. True if all is done.
  bool finish(const LoopBudget& budget, const render::RenderControl& control, render::RenderStatistics& statistics,
              const std::function<void(std::uint64_t)>& samplesFinished);
  /// Copies the band's sums into `result.film`, its counts into the statistics, and its path records, if any.
  void readBack(render::RenderResult& result);

 private:
  std::uint64_t pixels() const { return std::uint64_t{width_} * rows_.height; }
  double dispatch(const struct Rect& region, std::uint32_t segments, const LoopBudget& budget);
  /// Of the path records in results_.
  std::uint64_t recordOffset() const;
  const gpu::Counters& counters() const;
  std::uint64_t takeFinishedSamples();
  void readCounts(render::RenderStatistics& statistics);
  void readRecords(render::PathRecords& paths);

  vulkan::Device& device_;
  Kernel kernel_;
  std::vector<const vulkan::ComputePipeline*> pipelines_;
  const render::RenderSettings& settings_;
  std::uint32_t width_;
  BandRows rows_;
  std::uint32_t samplesSeen_ = 0;  ///< of the wrapping counter
  vulkan::Buffer states_;
  vulkan::Buffer film_;
  vulkan::Buffer results_;
  vulkan::Buffer counters_;  ///< copy of the head of results_, for the host
  vulkan::BindingSet bindings_;
};

}  // namespace candela::device

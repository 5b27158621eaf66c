// A scene on a device: its buffers and pipelines, and the film that it renders.
#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "host/trace/device/band.h"
#include "host/trace/device/device_context.h"
#include "host/trace/device/device_film.h"
#include "host/trace/device/device_scene.h"
#include "host/trace/device/kernel.h"
#include "host/trace/device/loop_budget.h"
#include "host/trace/flatten/camera_records.h"
#include "host/trace/render/session.h"

namespace candela::device {

class GpuSession final : public render::Session, public render::SampleReplayer, public render::PathRecorder {
 public:
  /// Throws as render::Renderer::prepare() does. The scene must outlive the object.
  GpuSession(std::shared_ptr<DeviceContext> context, const scene::Scene& scene, const render::RenderSettings& settings);

  bool advance(render::SampleRange range, const render::RenderControl& control) override;
  void restrictTo(const render::PixelMask& mask) override;
  image::Film film() override;
  void reset(std::uint32_t seed, std::uint32_t sampleCount) override;
  void setCamera(const scene::Camera& camera) override;
  void setView(const scene::Camera& camera, const render::Extent& size) override;
  void load(const image::Film& film, std::uint32_t first) override;
  render::RenderStatistics statistics() override;
  render::Salvage salvage() override;

  render::SampleReplayer* replayer() override {
    return settings_.image.integrator == render::Integrator::path ? this : nullptr;
  }
  render::Replay replay(const render::PixelSample& sample) override;

  render::PathRecorder* recorder() override { return settings_.execution.recordPaths ? this : nullptr; }
  render::PathRecords paths() override;

  /// Returns the film, also while advance() reports progress.
  const DeviceFilm& deviceFilm() const { return film_; }
  const vulkan::DeviceInfo& deviceInfo() const { return context_->device.info(); }
  /// Returns hostMemoryNeed() of the session's render.
  std::uint64_t hostBytes() const;
  /// Returns the bytes of all buffers of the session, including those of a band that is created later.
  std::uint64_t bufferBytes() const;

 private:
  /// Replaces a choice of loads that is left to the device by the device's.
  void chooseLoads();
  void prepareScene();
  void describe();
  vulkan::PipelineOptions pipelineOptions() const;
  std::vector<vulkan::ComputePipeline> pipelinesOf(const Kernel& kernel);
  void empty();
  void startCounting();
  void countSamples(render::RenderStatistics& statistics) const;
  std::unique_ptr<Band> tryBand();
  void makeBand();
  std::uint32_t preferredBandHeight() const;
  void fitBand();
  void retire();
  bool finishBySteps(BandRows rows, std::uint32_t sampleEnd, const render::RenderControl& control,
                     const std::function<void(std::uint64_t)>& samplesFinished);
  bool advanceBand(std::uint32_t index, std::uint32_t sampleEnd, const render::RenderControl& control,
                   const std::function<void(std::uint64_t)>& samplesFinished);

  std::shared_ptr<DeviceContext> context_;
  const scene::Scene& scene_;
  render::RenderSettings settings_;
  flatten::SceneShape shape_;
  flatten::CameraRecords cameraRecords_;
  Kernel kernel_;
  LoopBudget budget_;
  std::unique_ptr<DeviceScene> deviceScene_;
  std::unique_ptr<Band> band_;  ///< created when it is first needed
  bool warm_ = false;           ///< the driver has compiled the pipelines

  DeviceFilm film_;
  /// The result of statistics(), until something changes it: counting takes a copy of all path states.
  std::optional<render::RenderStatistics> counted_;
  render::RenderStatistics prepared_;    ///< of preparation
  render::RenderStatistics statistics_;  ///< of all work, except for the resident band's counts
  render::PathRecords paths_;            ///< of the bands before the resident one
};

}  // namespace candela::device

// The compute-shader tracer: upload, warm up, dispatch band by band under the governor, read back.
#include "host/device/gpu_renderer.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/core/errors.h"
#include "host/core/stopwatch.h"
#include "host/device/band.h"
#include "host/device/device_replay.h"
#include "host/device/kernel.h"
#include "host/device/loop_budget.h"
#include "host/device/pipeline_store.h"
#include "host/device/specialise.h"
#include "host/device/wavefront.h"
#include "host/device/workgroup.h"
#include "host/flatten/flat_scene.h"
#include "host/flatten/flatten_hierarchy.h"
#include "host/vulkan/device.h"
#include "host/vulkan/loop_limit.h"

namespace candela::device {
namespace {

const char* structureName(render::AccelKind accel) {
  switch (accel) {
    case render::AccelKind::none:
      return "none";
    case render::AccelKind::grid:
      return "grid";
    case render::AccelKind::bvh:
      break;
  }
  return "bvh";
}

class GpuRenderer final : public render::ReplayingRenderer {
 public:
  GpuRenderer(vulkan::Device device, const device::GpuRendererOptions& options)
      : device_(std::move(device)),
        loopLimit_(options.loopLimit ? *options.loopLimit : vulkan::probeLoopLimit(device_)) {}

  render::RenderResult render(const scene::Scene& scene, const render::RenderSettings& settings,
                              const render::RenderControl& control) override;
  render::Replay replay(const scene::Scene& scene, const render::RenderSettings& settings,
                        const render::PixelSample& sample) override;

 private:
  flatten::FlattenLimits limitsFor(std::uint32_t raysPerSegment) const;
  void describe(const Kernel& kernel, const flatten::FlatScene& flat, const render::RenderSettings& settings,
                bool texels, render::RenderStatistics& statistics) const;
  std::vector<const vulkan::ComputePipeline*> pipelinesOf(const Kernel& kernel, const vulkan::PipelineOptions& options);
  void renderBands(Band& band, std::uint32_t height, const LoopBudget& budget, const render::RenderSettings& settings,
                   const render::RenderControl& control, render::RenderResult& result);

  vulkan::Device device_;
  std::uint32_t loopLimit_;
  PipelineStore pipelines_;
};

void describeBuild(const render::RenderSettings& settings, render::RenderStatistics& statistics) {
  if (settings.structure.bvhSplit == render::BvhSplit::midpoint) {
    statistics.bvhSplit = "midpoint";
    return;
  }
  statistics.bvhSplit = "sah";
  statistics.bvhQuality = flatten::buildQualityName(settings.structure.bvhQuality);
}

flatten::FlattenLimits GpuRenderer::limitsFor(std::uint32_t raysPerSegment) const {
  return {mostGridSide(loopLimit_, device_.info(), raysPerSegment), flatten::smallSceneRule(device_.info())};
}

void GpuRenderer::describe(const Kernel& kernel, const flatten::FlatScene& flat, const render::RenderSettings& settings,
                           bool texels, render::RenderStatistics& statistics) const {
  statistics.device = device_.info().name;
  statistics.driver = device_.info().driver;
  statistics.structure = structureName(settings.structure.accel);
  if (settings.structure.accel == render::AccelKind::bvh) describeBuild(settings, statistics);
  statistics.layout = flat.uniformSlots > 0 ? "row" : flatten::layoutName(flat.structure);
  statistics.kernel = kernel.name;
  statistics.workgroup = settings.execution.workgroupInUse();
  statistics.automaticOrigin = settings.execution.automatic.origin;
  statistics.sceneLoads = texels ? "texel" : "storage";
  statistics.structureQuality = flat.structureQuality;
}

std::vector<const vulkan::ComputePipeline*> GpuRenderer::pipelinesOf(const Kernel& kernel,
                                                                     const vulkan::PipelineOptions& options) {
  std::vector<const vulkan::ComputePipeline*> pipelines;
  for (const std::span<const std::uint32_t> spirv : kernel.spirv) {
    pipelines.push_back(&pipelines_.get(device_, spirv, options));
  }
  return pipelines;
}

render::RenderResult GpuRenderer::render(const scene::Scene& scene, const render::RenderSettings& settings,
                                         const render::RenderControl& control) {
  requireWorkgroup(device_.info(), settings.execution.workgroupInUse());
  render::RenderResult result;
  render::RenderStatistics& statistics = result.statistics;
  Stopwatch watch;
  const std::uint32_t rays = mostRaysPerSegment(scene, settings);
  const flatten::FlatScene flat = flatten::flattenScene(scene, settings, limitsFor(rays));
  const Kernel kernel = kernelFor(flat, settings);
  LoopBudget budget = loopBudget(loopLimit_, device_.info(), flat, rays);
  if (kernel.isWavefront()) budget.maxSegments = std::min(budget.maxSegments, kMostRounds);
  statistics.seconds["build"] = watch.lap();
  statistics.seconds["structure"] = flat.structureSeconds;

  const DeviceScene deviceScene(device_, flat, loadsFor(device_.info(), flat, settings));
  statistics.seconds["upload"] = watch.lap();
  describe(kernel, flat, settings, deviceScene.readsTexels(), statistics);

  const std::vector<const vulkan::ComputePipeline*> pipelines = pipelinesOf(
      kernel, kernelOptions(flat, settings, deviceScene.readsTexels(), sizeof(gpu::DispatchConstants)));
  const std::uint32_t height = bandHeight(device_.info(), kernel, settings);
  result.film = image::Film(settings.image.size.width, settings.image.size.height);
  Band band(device_, kernel, pipelines, deviceScene, settings, height);
  statistics.seconds["pipeline"] = watch.lap();
  renderBands(band, height, budget, settings, control, result);
  statistics.deviceBytes = device_.memoryUse().peakBytes;
  return result;
}

void GpuRenderer::renderBands(Band& band, std::uint32_t height, const LoopBudget& budget,
                              const render::RenderSettings& settings, const render::RenderControl& control,
                              render::RenderResult& result) {
  const double total = static_cast<double>(settings.image.size.width) * settings.image.size.height * settings.image.sampleCount;
  std::uint64_t done = 0;
  const auto count = [&](std::uint64_t fresh) {
    done += fresh;
    if (control.progress) control.progress(static_cast<double>(done) / total, done);
  };
  render::RenderStatistics& statistics = result.statistics;
  for (std::uint32_t first = 0; first < settings.image.size.height && !result.interrupted; first += height) {
    Stopwatch watch;
    band.start({first, std::min(height, settings.image.size.height - first)});
    if (first == 0) {
      band.warmUp(budget);
      statistics.seconds["pipeline"] += watch.lap();
    }
    result.interrupted = !band.finish(budget, control, statistics, count);
    statistics.seconds["trace"] += watch.lap();
    band.readBack(result);
    statistics.seconds["readBack"] += watch.lap();
  }
}

render::Replay GpuRenderer::replay(const scene::Scene& scene, const render::RenderSettings& settings,
                                   const render::PixelSample& sample) {
  const std::uint32_t rays = mostRaysPerSegment(scene, settings);
  const flatten::FlatScene flat = flatten::flattenScene(scene, settings, limitsFor(rays));
  const LoopBudget budget = loopBudget(loopLimit_, device_.info(), flat, rays);
  const DeviceScene deviceScene(device_, flat, loadsFor(device_.info(), flat, settings));
  const Kernel kernel = replayKernel();
  render::Replay replay;
  describe(kernel, flat, settings, deviceScene.readsTexels(), replay.statistics);
  const std::vector<const vulkan::ComputePipeline*> pipelines = pipelinesOf(
      kernel, kernelOptions(flat, settings, deviceScene.readsTexels(), sizeof(gpu::DispatchConstants)));
  replay.path = replayOnDevice(device_, *pipelines.front(), deviceScene, sample, budget, replay.statistics);
  return replay;
}

}  // namespace

std::unique_ptr<render::ReplayingRenderer> makeGpuRenderer(const std::string& selector,
                                                           const device::GpuRendererOptions& options) {
  return makeGpuRenderer(vulkan::Device::open(selector), options);
}

std::unique_ptr<render::ReplayingRenderer> makeGpuRenderer(vulkan::Device device,
                                                           const device::GpuRendererOptions& options) {
  return std::make_unique<GpuRenderer>(std::move(device), options);
}

}  // namespace candela::device

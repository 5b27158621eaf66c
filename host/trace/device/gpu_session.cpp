// Prepares a session, and traces its samples band by band. A band stays on the device until another one needs its
// buffers.
#include "host/trace/device/gpu_session.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "host/base/errors.h"
#include "host/base/setting_words.h"
#include "host/base/stopwatch.h"
#include "host/trace/device/band_layout.h"
#include "host/trace/device/device_memory.h"
#include "host/trace/device/device_replay.h"
#include "host/trace/device/scene_kernels.h"
#include "host/trace/device/specialise.h"
#include "host/trace/device/wavefront.h"
#include "host/trace/device/workgroup.h"
#include "host/trace/flatten/camera_constants.h"
#include "host/trace/render/request.h"

namespace candela::device {
namespace {

void describeBuild(const render::StructureSettings& structure, render::RenderStatistics& statistics) {
  if (structure.bvhSplit == render::BvhSplit::midpoint) {
    statistics.bvhSplit = render::SplitInUse::midpoint;
    return;
  }
  statistics.bvhSplit = render::SplitInUse::sah;
  statistics.bvhQuality = structure.bvhQuality;
}

}  // namespace

GpuSession::GpuSession(std::shared_ptr<DeviceContext> context, const scene::Scene& scene,
                       const render::RenderSettings& settings)
    : context_(std::move(context)), scene_(scene), settings_(settings), film_(scene, settings.image.layers) {
  const vulkan::DeviceInfo& info = context_->device.info();
  render::requireIntegrator(scene_, settings_);
  requireWorkgroup(info, settings_.execution.workgroupInUse());
  chooseLoads();
  const std::uint64_t bytesBefore = context_->device.memoryUse().currentBytes;
  prepareScene();
  film_.setBandHeight(preferredBandHeight());
  prepared_.deviceBytes = context_->device.memoryUse().currentBytes - bytesBefore;
  film_.resize(settings_.image);
  startCounting();
}

void GpuSession::chooseLoads() {
  render::SceneLoads& loads = settings_.execution.automatic.sceneLoads;
  if (settings_.execution.sceneLoads != render::SceneLoads::automatic || loads != render::SceneLoads::automatic) return;
  if (!context_->fastestLoads) context_->fastestLoads = fastestLoads(context_->device);
  loads = *context_->fastestLoads;
}

// Flattens the scene and uploads it. Only its shape is stored on the host.
void GpuSession::prepareScene() {
  const vulkan::DeviceInfo& info = context_->device.info();
  Stopwatch watch;
  const std::uint32_t rays = maxRaysPerSegment(scene_, settings_);
  const flatten::FlatScene flat = flattenFor(info, context_->loopLimit, scene_, settings_, prepared_.warnings);
  shape_ = flat.shape;
  kernel_ = kernelFor(flat, settings_);
  budget_ = loopBudget(context_->loopLimit, info, shape_, rays);
  if (layerSumsOf(settings_.image.layers) != 0) {
    budget_.maxSegments = std::min(budget_.maxSegments, gpu::kMaxGatheredSamples);
  }
  if (kernel_.isWavefront()) budget_.maxSegments = std::min(budget_.maxSegments, kMaxRounds);
  cameraRecords_ = flatten::cameraRecordsOf(scene_, flat, settings_.image);
  prepared_.seconds["build"] = watch.lap();
  prepared_.seconds["structure"] = flat.structureSeconds;
  prepared_.structureQuality = flat.structureQuality;

  requireDeviceMemory(info, hostBytes(), std::span(flat.rows).size_bytes(), bandRowBytes(kernel_, settings_));
  deviceScene_ = std::make_unique<DeviceScene>(context_->device, flat, loadsFor(info, flat, settings_));
  prepared_.seconds["upload"] = watch.lap();
  describe();
}

void GpuSession::describe() {
  prepared_.device = context_->device.info().name;
  prepared_.driver = context_->device.info().driver;
  prepared_.onGpu = !context_->device.info().isSoftware();
  prepared_.platform = fmt::format("driver {}, pipeline cache {}", context_->device.info().driverUuid,
                                   context_->device.info().pipelineCacheUuid);
  prepared_.kernels = kernelsHash();
  prepared_.structure = settings_.structure.accel;
  if (prepared_.structure == render::AccelKind::bvh) describeBuild(settings_.structure, prepared_);
  prepared_.layout = shape_.layout();
  prepared_.kernel = kernel_.kind;
  prepared_.workgroup = settings_.execution.workgroupInUse();
  prepared_.automaticOrigin = settings_.execution.automatic.origin;
  prepared_.sceneLoads = deviceScene_->readsTexels() ? render::SceneLoads::texel : render::SceneLoads::storage;
}

vulkan::PipelineOptions GpuSession::pipelineOptions() const {
  return kernelOptions(context_->form, shape_, settings_, deviceScene_->readsTexels(), sizeof(gpu::DispatchConstants));
}

std::vector<vulkan::ComputePipeline> GpuSession::pipelinesOf(const Kernel& kernel) {
  std::vector<vulkan::ComputePipeline> pipelines;
  for (const std::span<const std::uint32_t> spirv : kernel.spirv) {
    pipelines.push_back(context_->pipelines.get(context_->device, spirv, pipelineOptions()));
  }
  return pipelines;
}

void GpuSession::startCounting() {
  statistics_ = prepared_;
  counted_.reset();
  paths_.clear();
}

void GpuSession::empty() {
  film_.clear();
  startCounting();
}

void GpuSession::reset(std::uint32_t seed, std::uint32_t sampleCount) {
  const bool jittered = settings_.image.jittersPixels();
  settings_.image.seed = seed;
  settings_.image.sampleCount = sampleCount;
  flatten::setSampling(cameraRecords_.constants, settings_.image);
  deviceScene_->updateConstants(cameraRecords_);
  if (band_ && settings_.image.jittersPixels() != jittered) band_->setPipelines(pipelinesOf(kernel_));
  empty();
}

void GpuSession::setCamera(const scene::Camera& camera) {
  flatten::moveCamera(scene_, camera, settings_.image, cameraRecords_, shape_);
  deviceScene_->update(cameraRecords_);
  if (band_) band_->setPipelines(pipelinesOf(kernel_));  // of the new camera's kind
  empty();
}

std::uint32_t GpuSession::preferredBandHeight() const {
  // A quarter of the memory for the largest of a band's buffers leaves space for the others and for the scene.
  const std::uint64_t memory = usableMemory(context_->device.info(), hostBytes()) / 4;
  return bandHeight(context_->device.info(), kernel_, settings_,
                    std::min({context_->maxBandBytes, settings_.execution.maxBandBytes, memory}));
}

std::uint64_t GpuSession::hostBytes() const { return hostMemoryNeed(scene_, settings_); }

std::uint64_t GpuSession::bufferBytes() const {
  return prepared_.deviceBytes + (band_ ? 0 : bandRowBytes(kernel_, settings_) * film_.bandHeight());
}

// Keeps the buffers of the band if the image fits into them.
void GpuSession::fitBand() {
  const render::Extent size = settings_.image.size;
  if (band_ && band_->setWidth(size.width) >= size.height) {
    film_.setBandHeight(size.height);
    return;
  }
  const std::uint64_t bytesBefore = context_->device.memoryUse().currentBytes;
  band_.reset();
  prepared_.deviceBytes -= bytesBefore - context_->device.memoryUse().currentBytes;
  film_.setBandHeight(preferredBandHeight());
}

void GpuSession::setView(const scene::Camera& camera, const render::Extent& size) {
  if (settings_.image.crop) throw UsageError("a session that renders a crop has one size");
  settings_.image.size = size;
  cameraRecords_.constants.imageWidth = size.width;
  cameraRecords_.constants.imageHeight = size.height;
  film_.resize(settings_.image);
  fitBand();
  setCamera(camera);
}

void GpuSession::load(const image::Film& film, std::uint32_t first) {
  const render::FilmCoverage coverage = render::coverageOf(film, first, settings_.image.window().extent(),
                                                           settings_.image.sampleCount);
  render::requireSameSums(film, settings_.image);
  film_.load(film, coverage);
  startCounting();
}

// Returns null if device memory has no room for a band of this height and a smaller one is possible.
std::unique_ptr<Band> GpuSession::tryBand() {
  try {
    return std::make_unique<Band>(context_->device, kernel_, pipelinesOf(kernel_), *deviceScene_, settings_,
                                  film_.bandHeight());
  } catch (const OutOfMemoryError& error) {
    if (film_.bandHeight() == 1) throw;
    statistics_.warnings.push_back(
        fmt::format("trying again with bands of {} rows: {}", (film_.bandHeight() + 1) / 2, error.what()));
    return nullptr;
  }
}

// Not called during preparation, because a session that only replays samples needs no band.
void GpuSession::makeBand() {
  const vulkan::MemoryUse before = context_->device.memoryUse();
  while ((band_ = tryBand()) == nullptr) film_.setBandHeight((film_.bandHeight() + 1) / 2);
  const vulkan::MemoryUse now = context_->device.memoryUse();
  prepared_.deviceBytes += now.currentBytes - before.currentBytes;
  statistics_.deviceBytes = prepared_.deviceBytes;
  if (now.systemBytes == before.systemBytes) return;
  statistics_.warnings.push_back(fmt::format(
      "the memory of {} is full, so that {} MiB are in system memory, which is slower: close other programs "
      "that use the device, or render a smaller image or a part of it ({} or {})",
      context_->device.info().name, (now.systemBytes - before.systemBytes) >> 20, settingWords("size"),
      settingWords("crop")));
}

// Takes the results of the resident band from the device.
void GpuSession::retire() {
  if (!film_.residentBand()) return;
  film_.update(statistics_);
  counted_.reset();
  band_->addCounts(statistics_);
  if (settings_.execution.recordPaths) band_->readRecords(paths_);
  film_.release();
}

void GpuSession::restrictTo(const render::PixelMask& mask) {
  retire();
  film_.restrictTo(mask);
}

// A pixel's list of hits has room for kListedHits samples. The host counts them before more are traced, so that film_
// has fetched all samples of earlier steps.
bool GpuSession::finishBySteps(BandRows rows, std::uint32_t sampleEnd, const render::RenderControl& control,
                               const std::function<void(std::uint64_t)>& samplesFinished) {
  std::uint32_t end = film_.coverage().first + film_.minSamples(rows);
  bool finished = true;
  while (finished && end < sampleEnd) {
    end = std::min(end + gpu::kListedHits, sampleEnd);
    finished = band_->finish(end, film_.pixelsLacking(rows, end), budget_, control, statistics_, samplesFinished);
    film_.fetch(statistics_);
  }
  return finished;
}

bool GpuSession::advanceBand(std::uint32_t index, std::uint32_t sampleEnd, const render::RenderControl& control,
                             const std::function<void(std::uint64_t)>& samplesFinished) {
  Stopwatch watch;
  counted_.reset();
  if (!band_) makeBand();  // first, since it decides the height of all bands
  const BandRows rows = film_.rowsOf(index);
  const std::uint64_t lacking = film_.pixelsLacking(rows, sampleEnd);
  if (lacking == 0) return true;
  if (film_.residentBand() != index) retire();
  film_.makeResident(index, *band_);
  if (!warm_) {
    band_->warmUp(sampleEnd, budget_);
    warm_ = true;
    prepared_.seconds["pipeline"] += watch.lap();
    statistics_.seconds["pipeline"] = prepared_.seconds["pipeline"];
  }
  const bool finished = hasMattes(settings_.image.layers)
                            ? finishBySteps(rows, sampleEnd, control, samplesFinished)
                            : band_->finish(sampleEnd, lacking, budget_, control, statistics_, samplesFinished);
  statistics_.seconds["trace"] += watch.lap();
  return finished;
}

bool GpuSession::advance(render::SampleRange range, const render::RenderControl& control) {
  if (film_.coverage().isUneven()) film_.update(statistics_);
  const std::uint32_t covered = film_.minSamples();
  render::requireContiguous(range, film_.coverage(), covered, settings_.image.sampleCount);
  if (film_.coverage().isEmpty()) film_.startAt(range.first);
  const std::uint32_t coveredEnd = film_.coverage().first + covered;
  if (range.end <= coveredEnd) return true;

  const render::Extent size = film_.size();
  const double total = static_cast<double>(std::uint64_t{size.width} * size.height) * (range.end - coveredEnd);
  std::uint64_t done = 0;
  const auto count = [&](std::uint64_t fresh) {
    done += fresh;
    if (control.progress) control.progress(std::min(1.0, static_cast<double>(done) / total), done);
  };
  bool finished = true;
  for (std::uint32_t i = 0; i < film_.bandCount() && finished; ++i) {
    finished = advanceBand(i, range.end, control, count);
  }
  if (finished) {
    film_.noteFinished(range.end);
  } else {
    film_.noteUneven();
  }
  return finished;
}

image::Film GpuSession::film() {
  film_.update(statistics_);
  return film_.fetched();
}

render::RenderStatistics GpuSession::statistics() {
  film_.update(statistics_);
  if (!counted_) {
    render::RenderStatistics result = statistics_;
    if (film_.residentBand()) band_->addCounts(result);
    countSamples(result);
    counted_ = std::move(result);
  }
  return *counted_;
}

void GpuSession::countSamples(render::RenderStatistics& statistics) const {
  const image::FilmCounts added = film_.added();
  statistics.samples += added.samples;
  statistics.badSamples += added.badSamples;
}

render::Salvage GpuSession::salvage() {
  render::Salvage salvage{{}, statistics_};
  if (film_.residentBand()) salvage.statistics.truncated += band_->truncated();
  countSamples(salvage.statistics);
  salvage.film = film_.take();
  return salvage;
}

render::PathRecords GpuSession::paths() {
  render::PathRecords paths = paths_;
  if (film_.residentBand()) band_->readRecords(paths);
  return paths;
}

render::Replay GpuSession::replay(const render::PixelSample& sample) {
  const std::vector<vulkan::ComputePipeline> pipelines = pipelinesOf(replayKernel());
  render::Replay replay{{}, prepared_};
  replay.path = replayOnDevice(context_->device, pipelines.front(), *deviceScene_, sample, settings_.image.maxDepth,
                               budget_, replay.statistics);
  return replay;
}

}  // namespace candela::device

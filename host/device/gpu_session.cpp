// Prepares a session, and keeps its film. A band stays on the device until another one needs its buffers.
#include "host/device/gpu_session.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "host/core/divide_up.h"
#include "host/core/errors.h"
#include "host/core/stopwatch.h"
#include "host/device/band_layout.h"
#include "host/device/device_memory.h"
#include "host/device/device_replay.h"
#include "host/device/hit_lists.h"
#include "host/device/small_scene_rule.h"
#include "host/device/specialise.h"
#include "host/device/wavefront.h"
#include "host/device/workgroup.h"
#include "host/flatten/camera_constants.h"
#include "host/render/request.h"

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
    : context_(std::move(context)), scene_(scene), settings_(settings) {
  const vulkan::DeviceInfo& info = context_->device.info();
  render::requireIntegrator(scene_, settings_);
  requireWorkgroup(info, settings_.execution.workgroupInUse());
  const std::uint64_t bytesBefore = context_->device.memoryUse().currentBytes;
  prepareScene();
  if (hasMattes(settings_.image.layers)) matteIds_.emplace(scene_);
  bandHeight_ = preferredBandHeight();
  prepared_.deviceBytes = context_->device.memoryUse().currentBytes - bytesBefore;
  film_ = render::emptyFilm(settings_.image, settings_.image.window().extent());
  startCounting();
}

// Flattens the scene and uploads it. Only its shape is stored on the host.
void GpuSession::prepareScene() {
  const vulkan::DeviceInfo& info = context_->device.info();
  Stopwatch watch;
  const std::uint32_t rays = maxRaysPerSegment(scene_, settings_);
  preferBvh(context_->loopLimit, info, scene_, rays, settings_.structure, prepared_.warnings);
  const flatten::FlatScene flat = flatten::flattenScene(
      scene_, settings_, {maxGridSideFor(context_->loopLimit, info, rays), smallSceneRule(info)});
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
  return kernelOptions(shape_, settings_, deviceScene_->readsTexels(), sizeof(gpu::DispatchConstants));
}

std::vector<vulkan::ComputePipeline> GpuSession::pipelinesOf(const Kernel& kernel) {
  std::vector<vulkan::ComputePipeline> pipelines;
  for (const std::span<const std::uint32_t> spirv : kernel.spirv) {
    pipelines.push_back(context_->pipelines.get(context_->device, spirv, pipelineOptions()));
  }
  return pipelines;
}

BandRows GpuSession::bandAt(std::uint32_t index) const {
  const std::uint32_t first = index * bandHeight_;
  return {first, std::min(bandHeight_, film_.height() - first)};
}

std::uint32_t GpuSession::bandCount() const { return divideUp(film_.height(), bandHeight_); }

std::span<image::FilmPixel> GpuSession::filmOf(BandRows rows) {
  const std::uint64_t width = film_.width();
  return {film_.pixels().data() + width * rows.first, width * rows.height};
}

std::span<image::LayerRow> GpuSession::layersOf(BandRows rows) {
  const std::uint64_t width = film_.layerRows().size() / film_.height();
  return std::span(film_.layerRows()).subspan(width * rows.first, width * rows.height);
}

void GpuSession::startCounting() {
  statistics_ = prepared_;
  counted_.reset();
  loaded_ = {};
  paths_.clear();
}

// The next band that becomes resident starts from film_.
void GpuSession::empty() {
  film_.clear();
  coverage_ = {};
  mask_.clear();
  resident_.reset();
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
  return prepared_.deviceBytes + (band_ ? 0 : bandRowBytes(kernel_, settings_) * bandHeight_);
}

// Keeps the buffers of the band if the image fits into them.
void GpuSession::fitBand() {
  const render::Extent size = settings_.image.size;
  if (band_ && band_->setWidth(size.width) >= size.height) {
    bandHeight_ = size.height;
    return;
  }
  const std::uint64_t bytesBefore = context_->device.memoryUse().currentBytes;
  band_.reset();
  prepared_.deviceBytes -= bytesBefore - context_->device.memoryUse().currentBytes;
  bandHeight_ = preferredBandHeight();
}

void GpuSession::setView(const scene::Camera& camera, const render::Extent& size) {
  if (settings_.image.crop) throw UsageError("a session that renders a crop has one size");
  settings_.image.size = size;
  cameraRecords_.constants.imageWidth = size.width;
  cameraRecords_.constants.imageHeight = size.height;
  resident_.reset();
  film_ = render::emptyFilm(settings_.image, size);
  fitBand();
  setCamera(camera);
}

const vulkan::Buffer* GpuSession::residentFilm() const {
  return resident_ && bandCount() == 1 ? &band_->film() : nullptr;
}

void GpuSession::load(const image::Film& film, std::uint32_t first) {
  const render::FilmCoverage coverage = render::coverageOf(film, first, settings_.image.window().extent(),
                                                           settings_.image.sampleCount);
  render::requireSameSums(film, settings_.image);
  empty();
  film_ = film;
  coverage_ = coverage;
  loaded_ = film_.counts();
}

void GpuSession::fetchFilm() {
  if (!resident_) return;
  Stopwatch watch;
  band_->readFilm(filmOf(bandAt(*resident_)), layersOf(bandAt(*resident_)));
  if (matteIds_) addListedHits(band_->readHitLists(), bandAt(*resident_).first, coverage_.first, *matteIds_, film_);
  statistics_.seconds["readBack"] += watch.lap();
  isFetched_ = true;
}

void GpuSession::updateFilm() {
  if (!isFetched_) fetchFilm();
}

image::Film GpuSession::film() {
  updateFilm();
  return film_;
}

render::RenderStatistics GpuSession::statistics() {
  updateFilm();
  if (!counted_) {
    render::RenderStatistics result = statistics_;
    if (resident_) band_->addCounts(result);
    countSamples(result);
    counted_ = std::move(result);
  }
  return *counted_;
}

void GpuSession::countSamples(render::RenderStatistics& statistics) const {
  const image::FilmCounts counts = film_.counts();
  statistics.samples += counts.samples - loaded_.samples;
  statistics.badSamples += counts.badSamples - loaded_.badSamples;
}

render::Salvage GpuSession::salvage() {
  render::Salvage salvage{{}, statistics_};
  if (resident_) salvage.statistics.truncated += band_->truncated();
  countSamples(salvage.statistics);
  salvage.film = std::move(film_);
  return salvage;
}

render::PathRecords GpuSession::paths() {
  render::PathRecords paths = paths_;
  if (resident_) band_->readRecords(paths);
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

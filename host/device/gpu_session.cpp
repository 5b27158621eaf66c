// Rendering band by band under the governor. A band stays on the device until another one needs its buffers.
#include "host/device/gpu_session.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "host/core/errors.h"
#include "host/core/stopwatch.h"
#include "host/device/device_memory.h"
#include "host/device/device_replay.h"
#include "host/device/hit_lists.h"
#include "host/device/specialise.h"
#include "host/device/wavefront.h"
#include "host/device/workgroup.h"
#include "host/flatten/flatten_hierarchy.h"
#include "host/render/request.h"

namespace candela::device {
namespace {

void describeBuild(const render::StructureSettings& structure, render::RenderStatistics& statistics) {
  if (structure.bvhSplit == render::BvhSplit::midpoint) {
    statistics.bvhSplit = "midpoint";
    return;
  }
  statistics.bvhSplit = "sah";
  statistics.bvhQuality = flatten::buildQualityName(structure.bvhQuality);
}

// Returns the number of pixels of the mask that lack samples before `sampleEnd`. Each pixel has consecutive samples
// from `firstSample` on. The first of `film` is the pixel `firstPixel` of the mask.
std::uint64_t countLacking(std::span<const image::FilmPixel> film, std::uint32_t firstSample, std::uint32_t sampleEnd,
                           const render::PixelMask& mask, std::size_t firstPixel) {
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < film.size(); ++i) {
    const bool lacks = firstSample + film[i].sampleCount < sampleEnd && render::isSelected(mask, firstPixel + i);
    count += lacks ? 1 : 0;
  }
  return count;
}

}  // namespace

GpuSession::GpuSession(std::shared_ptr<DeviceContext> context, const scene::Scene& scene,
                       const render::RenderSettings& settings)
    : context_(std::move(context)), scene_(scene), settings_(settings) {
  const vulkan::DeviceInfo& info = context_->device.info();
  render::requireIntegrator(scene_, settings_);
  requireWorkgroup(info, settings_.execution.workgroupInUse());
  const std::uint64_t bytesBefore = context_->device.memoryUse().currentBytes;
  Stopwatch watch;
  const std::uint32_t rays = maxRaysPerSegment(scene_, settings_);
  preferBvh(context_->loopLimit, info, scene_, rays, settings_.structure, prepared_.warnings);
  flat_ = flatten::flattenScene(scene_, settings_,
                                {maxGridSideFor(context_->loopLimit, info, rays), flatten::smallSceneRule(info)});
  kernel_ = kernelFor(flat_, settings_);
  if (hasMattes(settings_.image.layers)) matteIds_.emplace(scene_);
  budget_ = loopBudget(context_->loopLimit, info, flat_, rays);
  if (layerSumsOf(settings_.image.layers) != 0) {
    budget_.maxSegments = std::min(budget_.maxSegments, gpu::kMaxGatheredSamples);
  }
  if (kernel_.isWavefront()) budget_.maxSegments = std::min(budget_.maxSegments, kMaxRounds);
  cameraRecords_ = flatten::cameraRecordsOf(scene_, flat_, settings_.image);
  prepared_.seconds["build"] = watch.lap();
  prepared_.seconds["structure"] = flat_.structureSeconds;

  requireDeviceMemory(info, std::span(flat_.rows).size_bytes(), bandRowBytes(kernel_, settings_));
  deviceScene_ = std::make_unique<DeviceScene>(context_->device, flat_, loadsFor(info, flat_, settings_));
  flat_.rows = {};
  prepared_.seconds["upload"] = watch.lap();
  describe();

  bandHeight_ = preferredBandHeight();
  prepared_.deviceBytes = context_->device.memoryUse().currentBytes - bytesBefore;
  film_ = image::Film(settings_.image.window().width, settings_.image.window().height, settings_.image.layers);
  startCounting();
}

void GpuSession::describe() {
  prepared_.device = context_->device.info().name;
  prepared_.driver = context_->device.info().driver;
  prepared_.platform = fmt::format("driver {}, pipeline cache {}", context_->device.info().driverUuid,
                                   context_->device.info().pipelineCacheUuid);
  prepared_.kernels = kernelsHash();
  prepared_.structure = settings_.structure.accel;
  if (prepared_.structure == render::AccelKind::bvh) describeBuild(settings_.structure, prepared_);
  prepared_.layout = flat_.uniformSlots > 0 ? "row" : flatten::layoutName(flat_.structure);
  prepared_.kernel = kernel_.name;
  prepared_.workgroup = settings_.execution.workgroupInUse();
  prepared_.automaticOrigin = settings_.execution.automatic.origin;
  prepared_.sceneLoads = deviceScene_->readsTexels() ? "texel" : "storage";
  prepared_.structureQuality = flat_.structureQuality;
}

vulkan::PipelineOptions GpuSession::pipelineOptions() const {
  return kernelOptions(flat_, settings_, deviceScene_->readsTexels(), sizeof(gpu::DispatchConstants));
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

std::uint32_t GpuSession::bandCount() const { return (film_.height() + bandHeight_ - 1) / bandHeight_; }

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
  samplesLoaded_ = 0;
  badSamplesLoaded_ = 0;
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

void GpuSession::reset(std::uint32_t seed) {
  settings_.image.seed = seed;
  cameraRecords_.constants.seed = seed;
  flat_.constants.seed = seed;
  deviceScene_->update(cameraRecords_);
  empty();
}

void GpuSession::setCamera(const scene::Camera& camera) {
  flatten::moveCamera(scene_, camera, settings_.image, cameraRecords_);
  flat_.constants = cameraRecords_.constants;
  flat_.features.orthographic = camera.orthographicHeight.has_value();
  deviceScene_->update(cameraRecords_);
  if (band_) band_->setPipelines(pipelinesOf(kernel_));  // of the new camera's kind
  empty();
}

std::uint32_t GpuSession::preferredBandHeight() const {
  return bandHeight(context_->device.info(), kernel_, settings_,
                    std::min(context_->maxBandBytes, settings_.execution.maxBandBytes));
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
  film_ = image::Film(size.width, size.height, settings_.image.layers);
  fitBand();
  setCamera(camera);
}

const vulkan::Buffer* GpuSession::residentFilm() const {
  return resident_ && bandCount() == 1 ? &band_->film() : nullptr;
}

void GpuSession::load(const image::Film& film, std::uint32_t first) {
  const render::FilmCoverage coverage = render::coverageOf(film, first, settings_.image.window().extent(),
                                                           settings_.image.sampleCount);
  render::requireLayers(film, settings_.image.layers);
  empty();
  film_ = film;
  coverage_ = coverage;
  for (const image::FilmPixel& pixel : film_.pixels()) {
    samplesLoaded_ += pixel.sampleCount;
    badSamplesLoaded_ += pixel.badCount;
  }
}

void GpuSession::fetchFilm() {
  if (!resident_) return;
  Stopwatch watch;
  band_->readFilm(filmOf(bandAt(*resident_)), layersOf(bandAt(*resident_)));
  if (matteIds_) addListedHits(band_->readHitLists(), bandAt(*resident_).first, coverage_.first, *matteIds_, film_);
  statistics_.seconds["readBack"] += watch.lap();
}

// Returns null if device memory has no room for a band of this height and a smaller one is possible.
std::unique_ptr<Band> GpuSession::tryBand() {
  try {
    return std::make_unique<Band>(context_->device, kernel_, pipelinesOf(kernel_), *deviceScene_, settings_,
                                  bandHeight_);
  } catch (const OutOfMemoryError& error) {
    if (bandHeight_ == 1) throw;
    statistics_.warnings.push_back(fmt::format("bands of {} rows are tried: {}", (bandHeight_ + 1) / 2, error.what()));
    return nullptr;
  }
}

// Not called during preparation, because a session that only replays samples needs no band.
void GpuSession::makeBand() {
  const std::uint64_t bytesBefore = context_->device.memoryUse().currentBytes;
  while ((band_ = tryBand()) == nullptr) bandHeight_ = (bandHeight_ + 1) / 2;
  prepared_.deviceBytes += context_->device.memoryUse().currentBytes - bytesBefore;
  statistics_.deviceBytes = prepared_.deviceBytes;
}

// Takes the results of the resident band from the device.
void GpuSession::retire() {
  if (!resident_) return;
  fetchFilm();
  band_->addCounts(statistics_);
  if (settings_.execution.recordPaths) band_->readRecords(paths_);
  resident_.reset();
}

void GpuSession::restrictTo(const render::PixelMask& mask) {
  retire();
  mask_ = mask;
  coverage_.samples = render::FilmCoverage::kUneven;
}

void GpuSession::makeResident(std::uint32_t index) {
  if (resident_ == index) return;
  retire();
  const BandRows rows = bandAt(index);
  band_->load(rows, coverage_.isEmpty() ? std::span<const image::FilmPixel>{} : filmOf(rows), layersOf(rows),
              coverage_.first, mask_);
  resident_ = index;
}

std::uint64_t GpuSession::pixelsLacking(BandRows rows, std::uint32_t sampleEnd) {
  if (coverage_.samples != render::FilmCoverage::kUneven) {
    return coverage_.first + coverage_.samples < sampleEnd ? filmOf(rows).size() : 0;
  }
  return countLacking(filmOf(rows), coverage_.first, sampleEnd, mask_, std::size_t{film_.width()} * rows.first);
}

// A pixel's list of hits has room for kListedHits samples. The host counts them before more are traced, so that film_
// has all samples of earlier steps.
bool GpuSession::finishBySteps(BandRows rows, std::uint32_t sampleEnd, const render::RenderControl& control,
                               const std::function<void(std::uint64_t)>& samplesFinished) {
  std::uint32_t end = coverage_.first + render::minSampleCount(filmOf(rows));
  bool finished = true;
  while (finished && end < sampleEnd) {
    end = std::min(end + gpu::kListedHits, sampleEnd);
    const std::uint64_t lacking = countLacking(filmOf(rows), coverage_.first, end, mask_,
                                               std::size_t{film_.width()} * rows.first);
    finished = band_->finish(end, lacking, budget_, control, statistics_, samplesFinished);
    fetchFilm();
  }
  return finished;
}

bool GpuSession::advanceBand(std::uint32_t index, std::uint32_t sampleEnd, const render::RenderControl& control,
                             const std::function<void(std::uint64_t)>& samplesFinished) {
  Stopwatch watch;
  if (!band_) makeBand();  // first, since it decides the height of all bands
  const std::uint64_t lacking = pixelsLacking(bandAt(index), sampleEnd);
  if (lacking == 0) return true;
  makeResident(index);
  if (!warm_) {
    band_->warmUp(sampleEnd, budget_);
    warm_ = true;
    prepared_.seconds["pipeline"] += watch.lap();
    statistics_.seconds["pipeline"] = prepared_.seconds["pipeline"];
  }
  const bool finished = matteIds_ ? finishBySteps(bandAt(index), sampleEnd, control, samplesFinished)
                                  : band_->finish(sampleEnd, lacking, budget_, control, statistics_, samplesFinished);
  statistics_.seconds["trace"] += watch.lap();
  return finished;
}

bool GpuSession::advance(render::SampleRange range, const render::RenderControl& control) {
  const bool uneven = coverage_.samples == render::FilmCoverage::kUneven;
  if (uneven) fetchFilm();
  const std::uint32_t covered = uneven ? render::minSampleCount(film_.pixels()) : coverage_.samples;
  render::requireContiguous(range, coverage_, covered, settings_.image.sampleCount);
  if (coverage_.isEmpty()) {
    if (range.first != coverage_.first) resident_.reset();
    coverage_.first = range.first;
  }
  if (range.end <= coverage_.first + covered) return true;

  const double total = static_cast<double>(film_.pixels().size()) * (range.end - coverage_.first - covered);
  std::uint64_t done = 0;
  const auto count = [&](std::uint64_t fresh) {
    done += fresh;
    if (control.progress) control.progress(std::min(1.0, static_cast<double>(done) / total), done);
  };
  bool finished = true;
  for (std::uint32_t i = 0; i < bandCount() && finished; ++i) {
    finished = advanceBand(i, range.end, control, count);
  }
  const bool isEven = finished && mask_.empty();
  coverage_.samples = isEven ? range.end - coverage_.first : render::FilmCoverage::kUneven;
  return finished;
}

image::Film GpuSession::film() {
  fetchFilm();
  return film_;
}

render::RenderStatistics GpuSession::statistics() {
  fetchFilm();
  render::RenderStatistics result = statistics_;
  if (resident_) band_->addCounts(result);
  countSamples(result);
  return result;
}

void GpuSession::countSamples(render::RenderStatistics& statistics) const {
  for (const image::FilmPixel& pixel : film_.pixels()) {
    statistics.samples += pixel.sampleCount;
    statistics.badSamples += pixel.badCount;
  }
  statistics.samples -= samplesLoaded_;
  statistics.badSamples -= badSamplesLoaded_;
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
  if (resident_ && settings_.execution.recordPaths) band_->readRecords(paths);
  return paths;
}

render::Replay GpuSession::replay(const render::PixelSample& sample) {
  const std::vector<vulkan::ComputePipeline> pipelines = pipelinesOf(replayKernel());
  render::Replay replay{{}, prepared_};
  replay.path = replayOnDevice(context_->device, pipelines.front(), *deviceScene_, sample, budget_, replay.statistics);
  return replay;
}

}  // namespace candela::device

// Fills and reads the buffers of a band, and dispatches tiles until the band is finished.
#include "host/trace/device/band.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <limits>
#include <span>
#include <string_view>

#include "host/base/divide_up.h"
#include "host/base/errors.h"
#include "host/base/hash.h"
#include "host/trace/device/band_layout.h"
#include "host/trace/device/tile_cursor.h"
#include "host/trace/device/unfinished_rows.h"
#include "host/trace/device/wavefront.h"

namespace candela::device {
namespace {

constexpr std::uint64_t kChunkBytes = std::uint64_t{4} << 20;  // path states are copied in chunks of this size

// A pixel's state starts with a PathState or a TreeState, both of which have the sample index at the same offset.
constexpr std::size_t kSampleIndexOffset = offsetof(gpu::PathState, radianceSample) + 3 * sizeof(gpu::uint);
constexpr std::uint32_t kNever = 0x80000000u;  // index of a sample beyond every range
static_assert(offsetof(gpu::TreeState, radianceSample) == offsetof(gpu::PathState, radianceSample));
static_assert(offsetof(gpu::WaveState, path) == 0);

vulkan::Usage resultUsage(const Kernel& kernel) {
  return kernel.isWavefront() ? vulkan::Usage::storage | vulkan::Usage::indirect : vulkan::Usage::storage;
}

GovernorOptions governorOptions(const render::RenderSettings& settings, const LoopBudget& budget,
                                std::uint64_t pixels) {
  GovernorOptions options;
  options.limitSeconds *= settings.execution.dispatchSeconds / options.targetSeconds;
  options.targetSeconds = settings.execution.dispatchSeconds;
  options.maxSegments = std::min(options.maxSegments, budget.maxSegments);
  options.totalPixels = pixels;
  options.workgroupPixels = settings.execution.workgroupInUse().width * settings.execution.workgroupInUse().height;
  if (settings.execution.tile)
    options.fixedPixels = std::uint64_t{settings.execution.tile->width} * settings.execution.tile->height;
  if (settings.execution.segmentsPerDispatch)
    options.fixedSegments = std::min(*settings.execution.segmentsPerDispatch, budget.maxSegments);
  return options;
}

TileCursor cursorOver(render::Extent band, const render::RenderSettings& settings) {
  return settings.execution.tile ? TileCursor::ofTiles(band, *settings.execution.tile)
                                 : TileCursor(band, settings.execution.workgroupInUse());
}

void noteDispatch(const Rect& region, std::uint32_t segments, double seconds, render::RenderStatistics& statistics) {
  statistics.dispatchSeconds.push_back(seconds);
  statistics.maxSegmentsPerDispatch = std::max(statistics.maxSegmentsPerDispatch, segments);
  const std::uint64_t largest = std::uint64_t{statistics.tile.width} * statistics.tile.height;
  if (std::uint64_t{region.width} * region.height > largest) statistics.tile = {region.width, region.height};
}

render::VertexRecord unpackRecord(const gpu::uvec2& packed) {
  return {.primitive = packed.x,
          .lobe = static_cast<render::Lobe>(packed.y & 255u),
          .shadow = static_cast<render::ShadowOutcome>(packed.y >> 8 & 255u),
          .survivedRoulette = (packed.y >> 16 & 1u) != 0,
          .visibleLights = static_cast<std::uint16_t>((packed.y & ~gpu::kRecordValid) >> gpu::kRecordLightShift)};
}

}  // namespace

Band::Band(vulkan::Device& device, const Kernel& kernel, std::vector<vulkan::ComputePipeline> pipelines,
           const DeviceScene& scene, const render::RenderSettings& settings, std::uint32_t maxHeight)
    : device_(device),
      kernel_(kernel),
      pipelines_(std::move(pipelines)),
      settings_(settings),
      width_(settings.image.window().width),
      maxPixels_(std::uint64_t{width_} * maxHeight),
      states_(device, kernel.stateBytes * maxPixels_, vulkan::Usage::storage),
      film_(device, filmBytesPerPixel(settings) * maxPixels_, vulkan::Usage::storage),
      results_(device, resultBytes(kernel, settings, maxPixels_), resultUsage(kernel)),
      counters_(device, sizeof(gpu::Counters), vulkan::Usage::readback),
      bindings_(pipelines_.front(), {&scene.rows(), &states_, &film_, &results_, &scene.texels(), &scene.uniforms()}) {}

std::uint32_t Band::setWidth(std::uint32_t width) {
  width_ = width;
  return static_cast<std::uint32_t>(
      std::min<std::uint64_t>(maxPixels_ / width, std::numeric_limits<std::uint32_t>::max()));
}

void Band::load(BandRows rows, std::span<const image::FilmPixel> film, std::span<const image::LayerRow> layers,
                std::uint32_t firstSample, const render::PixelMask& mask) {
  rows_ = rows;
  sampled_ = sampledRegionOf(rows, width_, mask);
  samplesBefore_ = 0;
  truncatedBefore_ = 0;
  volumeFaultsBefore_ = 0;
  planner_.reset();
  stallWatch_ = {};
  device_.run([&](vulkan::CommandRecorder& recorder) {
    recorder.fillBuffer(states_, 0, 0, kernel_.stateBytes * pixels());
    recorder.fillBuffer(film_, 0, 0, filmBytesPerPixel(settings_) * pixels());
    recorder.fillBuffer(results_, 0);
    recorder.fillBuffer(counters_, 0);
  });
  samplesSeen_ = 0;
  if (film.empty() && firstSample == 0 && mask.empty()) return;
  if (!film.empty()) film_.upload(std::as_bytes(film));
  if (!film.empty() && !layers.empty()) film_.upload(std::as_bytes(layers), std::as_bytes(film).size());
  setFirstSamples(film, firstSample, mask);
}

// All other words of a state whose sample has not started are 0. Kernels skip pixels whose index is at the end.
void Band::setFirstSamples(std::span<const image::FilmPixel> film, std::uint32_t firstSample,
                           const render::PixelMask& mask) {
  const std::uint64_t size = kernel_.stateBytes;
  const std::uint64_t chunk = std::min(pixels(), kChunkBytes / size);
  for (std::uint64_t first = 0; first < pixels(); first += chunk) {
    std::vector<std::byte> states(std::min(chunk, pixels() - first) * size);
    for (std::uint64_t i = 0; i * size < states.size(); ++i) {
      const std::uint64_t pixel = std::uint64_t{width_} * rows_.first + first + i;
      const bool getsSamples = render::isSelected(mask, pixel);
      const std::uint32_t index = getsSamples ? firstSample + (film.empty() ? 0 : film[first + i].sampleCount) : kNever;
      std::memcpy(&states[i * size + kSampleIndexOffset], &index, sizeof index);
      samplesBefore_ += index;
    }
    states_.upload(states, first * size);
  }
}

void Band::clearCounters() {
  truncatedBefore_ += counters().truncated;
  volumeFaultsBefore_ += counters().volumeFaults;
  device_.run([&](vulkan::CommandRecorder& recorder) {
    recorder.fillBuffer(results_, 0, 0, sizeof(gpu::Counters));
    recorder.fillBuffer(counters_, 0);
  });
  samplesSeen_ = 0;
}

double Band::dispatch(const Rect& region, std::uint32_t segments, std::uint32_t sampleEnd, const LoopBudget& budget) {
  const render::Window window = settings_.image.window();
  const std::uint32_t firstRow = window.y + rows_.first;
  const gpu::DispatchConstants constants{.regionOrigin = {window.x + region.x, firstRow + region.y},
                                         .regionSize = {region.width, region.height},
                                         .firstRow = firstRow,
                                         .maxSegments = segments,
                                         .sampleEnd = sampleEnd,
                                         .maxIterations = budget.maxIterations,
                                         .roundParity = 0,
                                         .bandPixels = static_cast<std::uint32_t>(pixels()),
                                         .firstColumn = window.x};
  const render::Extent workgroup = settings_.execution.workgroupInUse();
  const vulkan::GroupCount count{divideUp(region.width, workgroup.width), divideUp(region.height, workgroup.height), 1};
  const auto record = [&](vulkan::CommandRecorder& recorder) {
    if (kernel_.isWavefront()) {
      const std::uint64_t longestPixel = std::uint64_t{sampleEnd} * settings_.image.maxDepth;
      const auto rounds = static_cast<std::uint32_t>(std::min<std::uint64_t>(segments, longestPixel));
      recordRounds(recorder, pipelines_, bindings_, results_, constants, count, rounds);
    } else {
      recorder.dispatch(pipelines_.front(), bindings_, std::as_bytes(std::span(&constants, 1)), count);
    }
    recorder.copyBuffer(results_, 0, counters_, 0, sizeof(gpu::Counters));
  };
  return device_.run(record);
}

const gpu::Counters& Band::counters() const {
  return *reinterpret_cast<const gpu::Counters*>(counters_.mapped().data());
}

std::uint64_t Band::takeFinishedSamples() {
  const std::uint32_t now = counters().finishedSamples;
  const std::uint32_t fresh = now - samplesSeen_;
  samplesSeen_ = now;
  return fresh;
}

std::uint64_t Band::stateHash() const {
  std::uint64_t hash = fnv1a({});
  const std::uint64_t size = kernel_.stateBytes * pixels();
  std::vector<std::byte> chunk(std::min(size, kChunkBytes));
  for (std::uint64_t at = 0; at < size; at += chunk.size()) {
    const std::span part = std::span(chunk).first(std::min<std::uint64_t>(chunk.size(), size - at));
    states_.download(part, at);
    hash = fnv1aOfText({reinterpret_cast<const char*>(part.data()), part.size()}, hash);
  }
  return hash;
}

void Band::requireProgress(std::uint64_t samplesFinished) {
  if (!stallWatch_.mustCompare(samplesFinished, planner_->sweeps()) || !stallWatch_.isStalled(stateHash())) return;
  throw DeviceLostError(
      fmt::format("{} ({}) reports success, but has traced no path further in {} dispatches of every pixel",
                  device_.info().name, device_.info().driver, StallWatch::kSweeps));
}

void Band::warmUp(std::uint32_t sampleEnd, const LoopBudget& budget) {
  const render::Extent workgroup = settings_.execution.workgroupInUse();
  const render::Extent corner{std::min(sampled_.box.width, workgroup.width),
                              std::min(sampled_.box.height, workgroup.height)};
  dispatch({sampled_.box.x, sampled_.box.y, corner.width, corner.height}, 1, sampleEnd, budget);
}

bool Band::finish(std::uint32_t sampleEnd, std::uint64_t pixelsLeft, const LoopBudget& budget,
                  const render::RenderControl& control, render::RenderStatistics& statistics,
                  const std::function<void(std::uint64_t)>& samplesFinished) {
  if (!planner_) {
    planner_.emplace(cursorOver({sampled_.box.width, sampled_.box.height}, settings_),
                     governorOptions(settings_, budget, pixels()), sampled_.box.height);
  }
  UnfinishedRows unfinished(sampled_.box.width, sampled_.selectedInRows);
  samplesFinished(takeFinishedSamples());  // those of the warm-up
  while (counters().finishedPixels < pixelsLeft) {
    if (control.stop != nullptr && *control.stop) {
      clearCounters();
      return false;
    }
    const PlannedDispatch plan = planner_->next(unfinished);
    const Rect& region = plan.region;
    const std::uint32_t finishedBefore = counters().finishedPixels;
    const Rect inBand{sampled_.box.x + region.x, sampled_.box.y + region.y, region.width, region.height};
    const double seconds = dispatch(inBand, plan.segments, sampleEnd, budget);
    planner_->record(plan, seconds);
    unfinished.finish(region, counters().finishedPixels - finishedBefore);
    noteDispatch(region, plan.segments, seconds, statistics);
    const std::uint64_t samples = takeFinishedSamples();
    samplesFinished(samples);
    requireProgress(samples);
  }
  clearCounters();
  return true;
}

void Band::readFilm(std::span<image::FilmPixel> film, std::span<image::LayerRow> layers) const {
  film_.download(std::as_writable_bytes(film));
  if (layers.empty()) return;
  film_.download(std::as_writable_bytes(layers), std::as_bytes(film).size());
  const std::size_t rowCount = layers.size() / film.size();
  for (std::size_t i = 0; i < layers.size(); ++i) {
    layers[i].pending = 0;
    if (i % rowCount == 0) layers[i].words[2] = 0;  // pending units
  }
}

std::vector<std::uint32_t> Band::readHitLists() const {
  std::vector<std::uint32_t> lists(pixels() * gpu::kListedHits);
  film_.download(std::as_writable_bytes(std::span(lists)), hitListOffset(settings_, pixels()));
  return lists;
}

void Band::addCounts(render::RenderStatistics& statistics) const {
  const std::uint64_t size = kernel_.stateBytes;
  const std::uint64_t chunk = std::min(pixels(), kChunkBytes / size);
  std::vector<std::byte> buffer(chunk * size);
  for (std::uint64_t first = 0; first < pixels(); first += chunk) {
    const std::span states(buffer.data(), std::min(chunk, pixels() - first) * size);
    states_.download(states, first * size);
    for (std::uint64_t at = 0; at < states.size(); at += size) kernel_.addCounts(states.subspan(at, size), statistics);
  }
  statistics.cameraRays -= samplesBefore_;
  statistics.truncated += truncated();
  statistics.volumeFaults += volumeFaultsBefore_ + counters().volumeFaults;
}

void Band::readRecords(render::PathRecords& paths) const {
  std::vector<gpu::uvec2> packed(pixels() * gpu::kRecordedVertices);
  results_.download(std::as_writable_bytes(std::span(packed)), recordOffset(kernel_, pixels()));
  for (std::uint64_t pixel = 0; pixel < pixels(); ++pixel) {
    render::PathRecord& path = paths.emplace_back();
    for (std::uint32_t i = 0; i < gpu::kRecordedVertices; ++i) {
      const gpu::uvec2& entry = packed[pixel * gpu::kRecordedVertices + i];
      if ((entry.y & gpu::kRecordValid) == 0) break;
      path.vertices[path.vertexCount++] = unpackRecord(entry);
    }
  }
}

}  // namespace candela::device

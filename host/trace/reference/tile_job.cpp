// Distributes tiles to threads.
#include "host/trace/reference/tile_job.h"

#include <algorithm>
#include <vector>

#include "host/base/divide_up.h"
#include "host/base/run_on_threads.h"

namespace candela::reference {
namespace {

double samplesLacking(const JobOutput& output, std::uint32_t sampleEnd) {
  double samples = 0;
  const std::vector<image::FilmPixel>& pixels = output.film.pixels();
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const std::uint32_t next = output.firstSample + pixels[i].sampleCount;
    samples += next < sampleEnd && render::isSelected(output.mask, i) ? sampleEnd - next : 0;
  }
  return samples;
}

}  // namespace

TileJob::TileJob(const PixelTracer& tracer, render::Extent tile, std::uint32_t sampleEnd,
                 const render::RenderControl& control, JobOutput output)
    : tracer_(tracer),
      tile_(tile),
      sampleEnd_(sampleEnd),
      control_(control),
      output_(output),
      tilesAcross_(divideUp(output.film.width(), tile.width)),
      tileCount_(std::uint64_t{tilesAcross_} * divideUp(output.film.height(), tile.height)),
      totalSamples_(samplesLacking(output, sampleEnd)),
      hasSums_(!output.film.layerRows().empty()) {}

Counters TileJob::run(std::uint32_t threads) {
  std::vector<Counters> counters(threads);
  runOnThreads(threads, [&](std::uint32_t thread, const std::stop_token& stop) {
    while (!stop.stop_requested() && renderNextTile(counters[thread])) {
      if (thread == 0) reportProgress();
    }
  });
  Counters total;
  for (const Counters& counter : counters) total += counter;
  return total;
}

bool TileJob::renderNextTile(Counters& shared) {
  const std::uint64_t index = nextTile_.fetch_add(1);
  if (index >= tileCount_) return false;
  const auto column = static_cast<std::uint32_t>(index % tilesAcross_);
  const auto row = static_cast<std::uint32_t>(index / tilesAcross_);
  Counters counters;
  const bool finished = renderTile(column * tile_.width, row * tile_.height, counters);
  samplesDone_.fetch_add(counters.samples);
  shared += counters;
  return finished;
}

bool TileJob::renderTile(std::uint32_t left, std::uint32_t top, Counters& counters) {
  const std::uint32_t right = std::min(left + tile_.width, output_.film.width());
  const std::uint32_t bottom = std::min(top + tile_.height, output_.film.height());
  for (std::uint32_t y = top; y < bottom; ++y) {
    for (std::uint32_t x = left; x < right; ++x) {
      if (!renderPixel(x, y, counters)) {
        interrupted_ = true;
        return false;
      }
    }
  }
  return true;
}

bool TileJob::renderPixel(std::uint32_t x, std::uint32_t y, Counters& counters) {
  const std::size_t pixel = std::size_t{y} * output_.film.width() + x;
  if (!render::isSelected(output_.mask, pixel)) return true;
  for (std::uint32_t i = output_.firstSample + output_.film.at(x, y).sampleCount; i < sampleEnd_; ++i) {
    if (isStopped()) return false;
    render::PathRecord* record = output_.paths.empty() || i > 0 ? nullptr : &output_.paths[pixel];
    const render::PixelSample sample{output_.window.x + x, output_.window.y + y, i};
    const std::uint64_t verticesBefore = counters.vertices;
    image::LayerSample layers;
    const bool wantsLayers = hasSums_ || output_.matteIds != nullptr;
    const dvec3 radiance = traceSample(sample, pixel, counters, {record, wantsLayers ? &layers : nullptr});
    output_.film.addSample(x, y, radiance, i);
    if (hasSums_) output_.film.addLayers(x, y, layers, radiance);
    if (output_.matteIds != nullptr) addIds(x, y, layers);
    if (output_.countsHits && counters.vertices > verticesBefore) output_.film.addHit(x, y);
  }
  return true;
}

void TileJob::addIds(std::uint32_t x, std::uint32_t y, const image::LayerSample& sample) {
  for (const image::MatteKind kind : image::kMatteKinds) {
    if (output_.film.ids(kind).empty()) continue;
    const std::uint32_t id = sample.hit ? output_.matteIds->of(kind, sample.hit->primitive) : image::kNoId;
    image::addIds(output_.film.idsAt(kind, x, y), {id, 1});
  }
}

dvec3 TileJob::traceSample(const render::PixelSample& sample, std::size_t pixel, Counters& counters,
                           SampleOutputs outputs) {
  if (output_.replicaTracer == nullptr) return tracer_.sample(sample.x, sample.y, sample.index, counters, outputs);
  const std::uint32_t count = output_.replicaCount;
  render::Replica* const replicas = sample.index > 0 ? nullptr : &output_.replicas.replicas[count * pixel];
  return output_.replicaTracer->trace(sample, count, counters, outputs, output_.replicas.deviations[pixel], replicas);
}

// Tiles that were finished before do not count as progress.
void TileJob::reportProgress() {
  const std::uint64_t done = samplesDone_.load();
  if (!control_.progress || done == samplesReported_) return;
  samplesReported_ = done;
  control_.progress(totalSamples_ > 0 ? static_cast<double>(done) / totalSamples_ : 1, done);
}

}  // namespace candela::reference

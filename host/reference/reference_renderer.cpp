// Renders with the reference tracer: threads over tiles, one writer per pixel.
#include "host/reference/reference_renderer.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <new>
#include <thread>
#include <vector>

#include "host/core/errors.h"
#include "host/core/stopwatch.h"
#include "host/reference/path.h"
#include "host/reference/views.h"
#include "host/reference/whitted.h"

namespace candela::reference {
namespace {

constexpr render::Extent kDefaultTile{16, 16};

std::uint32_t threadCount(const render::RenderSettings& settings) {
  return settings.execution.threads > 0 ? settings.execution.threads : std::max(1u, std::thread::hardware_concurrency());
}

std::unique_ptr<PixelTracer> makeTracer(const scene::Scene& scene, const render::RenderSettings& settings) {
  if (settings.image.integrator == render::Integrator::whitted)
    return std::make_unique<reference::WhittedTracer>(scene, settings);
  if (isView(settings.image.integrator)) return std::make_unique<reference::ViewTracer>(scene, settings);
  return std::make_unique<reference::PathTracer>(scene, settings);
}

// One render in progress: hands out tiles, and keeps what its threads add to.
class Job {
 public:
  Job(const PixelTracer& tracer, const render::RenderSettings& settings, const render::RenderControl& control,
      render::RenderResult& result)
      : tracer_(tracer),
        settings_(settings),
        control_(control),
        result_(result),
        tile_(settings.execution.tile.value_or(kDefaultTile)),
        tilesAcross_((settings.image.size.width + tile_.width - 1) / tile_.width),
        tileCount_(std::uint64_t{tilesAcross_} * ((settings.image.size.height + tile_.height - 1) / tile_.height)) {}

  render::Extent tile() const { return tile_; }
  bool wasInterrupted() const { return interrupted_; }

  // The calling thread works too and alone reports progress, so that callbacks need not be thread-safe. What they throw
  // stops the other threads.
  Counters run(std::uint32_t threads) {
    std::vector<Counters> counters(threads);
    {
      std::vector<std::jthread> helpers;
      for (std::uint32_t i = 1; i < threads; ++i) {
        helpers.emplace_back([this, &counter = counters[i]](std::stop_token stop) {
          while (!stop.stop_requested() && renderNextTile(counter)) {
          }
        });
      }
      while (renderNextTile(counters[0])) reportProgress();
      for (std::jthread& helper : helpers) helper.join();
    }
    Counters total;
    for (const Counters& counter : counters) total += counter;
    return total;
  }

 private:
  bool isStopped() const { return control_.stop && control_.stop->load(std::memory_order_relaxed); }

  bool renderNextTile(Counters& shared) {
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

  bool renderTile(std::uint32_t left, std::uint32_t top, Counters& counters) {
    const std::uint32_t right = std::min(left + tile_.width, settings_.image.size.width);
    const std::uint32_t bottom = std::min(top + tile_.height, settings_.image.size.height);
    for (std::uint32_t y = top; y < bottom; ++y) {
      for (std::uint32_t x = left; x < right; ++x) {
        if (isStopped()) {
          interrupted_ = true;
          return false;
        }
        renderPixel(x, y, counters);
      }
    }
    return true;
  }

  void renderPixel(std::uint32_t x, std::uint32_t y, Counters& counters) {
    const std::size_t pixel = std::size_t{y} * settings_.image.size.width + x;
    for (std::uint32_t sample = 0; sample < settings_.image.sampleCount; ++sample) {
      render::PathRecord* record = result_.paths.empty() || sample > 0 ? nullptr : &result_.paths[pixel];
      result_.film.addSample(x, y, tracer_.sample(x, y, sample, counters, record), sample);
    }
  }

  void reportProgress() const {
    if (!control_.progress) return;
    const std::uint64_t done = samplesDone_.load();
    const double total = double{1} * settings_.image.size.width * settings_.image.size.height * settings_.image.sampleCount;
    control_.progress(static_cast<double>(done) / total, done);
  }

  const PixelTracer& tracer_;
  const render::RenderSettings& settings_;
  const render::RenderControl& control_;
  render::RenderResult& result_;
  render::Extent tile_;
  std::uint32_t tilesAcross_;
  std::uint64_t tileCount_;
  std::atomic<std::uint64_t> nextTile_{0};
  std::atomic<std::uint64_t> samplesDone_{0};
  std::atomic<bool> interrupted_{false};
};

void addCounters(const Counters& counters, render::Integrator integrator, render::RenderStatistics& statistics) {
  statistics.samples = counters.samples;
  statistics.cameraRays = counters.cameraRays;
  statistics.bounceRays = counters.bounceRays;
  statistics.shadowRays = counters.shadowRays;
  statistics.vertices = counters.vertices;
  statistics.traversalSteps = counters.traversalSteps;
  if (integrator != render::Integrator::whitted) return;
  statistics.treeRays = {
      .cameraHits = counters.cameraHits, .reflected = counters.reflectedRays, .refracted = counters.refractedRays};
}

void describeStructure(const reference::Tracing& tracing, const render::RenderSettings& settings,
                       render::RenderStatistics& statistics) {
  statistics.structure = "none";
  if (tracing.hasHierarchy()) {
    statistics.structure = "bvh";
    statistics.bvhSplit = settings.structure.bvhSplit == render::BvhSplit::midpoint ? "midpoint" : "median";
    statistics.structureQuality["nodes"] = static_cast<double>(tracing.hierarchy().nodes.size());
  }
  if (tracing.hasGrid()) {
    statistics.structure = "grid";
    statistics.structureQuality["cells"] = static_cast<double>(tracing.grid().starts.size() - 1);
    statistics.structureQuality["references"] = static_cast<double>(tracing.grid().items.size());
  }
}

std::uint64_t badSampleCount(const image::Film& film) {
  std::uint64_t count = 0;
  for (const image::FilmPixel& pixel : film.pixels()) count += pixel.badCount;
  return count;
}

// What `work` gives; memory that runs out is told as such.
template <class Work>
auto guarded(Work&& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    throw OutOfMemoryError("the reference tracer ran out of memory; render a smaller image or a smaller scene");
  }
}

class ReferenceRenderer final : public render::ReplayingRenderer {
 public:
  render::RenderResult render(const scene::Scene& scene, const render::RenderSettings& settings,
                              const render::RenderControl& control) override {
    return guarded([&] { return renderUnguarded(scene, settings, control); });
  }

  render::Replay replay(const scene::Scene& scene, const render::RenderSettings& settings,
                        const render::PixelSample& sample) override {
    return guarded([&] {
      const reference::PathTracer tracer(scene, settings);
      render::Replay replay{tracer.trace(sample), {}};
      replay.statistics.device = "cpu";
      replay.statistics.kernel = "reference";
      describeStructure(tracer.tracing(), settings, replay.statistics);
      return replay;
    });
  }

 private:
  static render::RenderResult renderUnguarded(const scene::Scene& scene, const render::RenderSettings& settings,
                                              const render::RenderControl& control) {
    const auto [width, height] = settings.image.size;
    render::RenderResult result;
    result.film = image::Film(width, height);
    if (settings.execution.recordPaths) result.paths.resize(std::size_t{width} * height);

    render::RenderStatistics& statistics = result.statistics;
    statistics.device = "cpu";
    statistics.kernel = "reference";
    statistics.threads = threadCount(settings);

    Stopwatch watch;
    const std::unique_ptr<PixelTracer> tracer = makeTracer(scene, settings);
    statistics.seconds["build"] = watch.lap();
    statistics.seconds["structure"] = statistics.seconds["build"];  // there is little else to make ready
    describeStructure(tracer->tracing(), settings, statistics);

    watch.lap();
    Job job(*tracer, settings, control, result);
    addCounters(job.run(statistics.threads), settings.image.integrator, statistics);
    statistics.seconds["trace"] = watch.lap();
    statistics.tile = job.tile();
    result.interrupted = job.wasInterrupted();
    statistics.badSamples = badSampleCount(result.film);
    return result;
  }
};

}  // namespace

std::unique_ptr<render::ReplayingRenderer> makeReferenceRenderer() { return std::make_unique<ReferenceRenderer>(); }

}  // namespace candela::reference

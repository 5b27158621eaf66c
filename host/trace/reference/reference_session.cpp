// Sessions of the reference tracer.
#include "host/trace/reference/reference_session.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>

#include "host/base/errors.h"
#include "host/base/run_on_threads.h"
#include "host/base/setting_words.h"
#include "host/base/stopwatch.h"
#include "host/base/version.h"
#include "host/trace/reference/tile_job.h"
#include "host/trace/reference/views.h"
#include "host/trace/reference/whitted.h"
#include "host/trace/render/request.h"

namespace candela::reference {
namespace {

constexpr render::Extent kDefaultTile{16, 16};

std::unique_ptr<PixelTracer> makeTracer(const scene::Scene& scene, const render::RenderSettings& settings) {
  if (settings.image.integrator == render::Integrator::whitted) return std::make_unique<WhittedTracer>(scene, settings);
  if (isView(settings.image.integrator)) return std::make_unique<ViewTracer>(scene, settings);
  return std::make_unique<PathTracer>(scene, settings);
}

void describeStructure(const Tracing& tracing, const render::RenderSettings& settings,
                       render::RenderStatistics& statistics) {
  if (tracing.hasHierarchy()) {
    statistics.structure = render::AccelKind::bvh;
    statistics.bvhSplit = settings.structure.bvhSplit == render::BvhSplit::midpoint ? render::SplitInUse::midpoint
                                                                                    : render::SplitInUse::median;
    statistics.structureQuality["nodes"] = static_cast<double>(tracing.nodeCount());
    if (!tracing.instances().empty()) {
      statistics.structureQuality["instances"] = static_cast<double>(tracing.instances().instances().size());
    }
  }
  if (tracing.hasGrid()) {
    statistics.structure = render::AccelKind::grid;
    statistics.structureQuality["cells"] = static_cast<double>(tracing.grid().starts.size() - 1);
    statistics.structureQuality["references"] = static_cast<double>(tracing.grid().items.size());
  }
}

/// Notes the cost of a scene's request for no acceleration structure, which the reference follows.
void noteCost(const scene::Scene& scene, const render::RenderSettings& settings, render::RenderStatistics& statistics) {
  constexpr std::size_t kMany = 10000;
  const bool isRequested = settings.structure.accel == render::AccelKind::none && settings.structure.accelIsPreference;
  if (!isRequested || scene.primitives.size() < kMany) return;
  statistics.warnings.push_back(
      fmt::format("the scene requests no acceleration structure, so that every ray tests {} primitives: {} is "
                  "faster and gives the same image",
                  scene.primitives.size(), settingWords("accel", "bvh")));
}

// Returns the result of `work`. Running out of memory is reported as OutOfMemoryError.
template <class Work>
auto guarded(Work&& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    throw OutOfMemoryError("the reference tracer ran out of memory; render a smaller image or a smaller scene");
  }
}

}  // namespace

ReferenceSession::ReferenceSession(const scene::Scene& scene, const render::RenderSettings& settings)
    : settings_(settings) {
  render::requireIntegrator(scene, settings_);
  prepared_.device = render::kReferenceDevice;
  prepared_.kernel = render::KernelInUse::reference;
  prepared_.kernels = "reference";
  prepared_.platform = toolchainText();
  prepared_.threads = threadCountFor(settings_.execution.threads);
  Stopwatch watch;
  guarded([&] {
    tracer_ = makeTracer(scene, settings_);
    pathTracer_ = dynamic_cast<const PathTracer*>(tracer_.get());
    prepareReplicas(*scene.camera);
    if (hasMattes(settings_.image.layers)) matteIds_.emplace(scene);
    film_ = render::emptyFilm(settings_.image, settings_.image.window().extent());
    empty();
  });
  prepared_.seconds["build"] = watch.lap();
  prepared_.seconds["structure"] = prepared_.seconds["build"];  // nothing else takes long
  describeStructure(tracer_->tracing(), settings_, prepared_);
  noteCost(scene, settings_, prepared_);
  statistics_ = prepared_;
}

void ReferenceSession::prepareReplicas(const scene::Camera& camera) {
  if (settings_.execution.replicas > 0) replicaTracer_.emplace(*tracer_, dvec3(camera.from));
}

void ReferenceSession::empty() {
  film_.clear();
  coverage_ = {};
  mask_.clear();
  paths_.clear();
  if (settings_.execution.recordPaths) paths_.resize(film_.pixels().size());
  const std::uint32_t replicaCount = settings_.execution.replicas;
  replicas_.replicas.assign(replicaCount * film_.pixels().size(), {});
  replicas_.deviations.assign(replicaCount > 0 ? film_.pixels().size() : 0, {});
  statistics_ = prepared_;
  badSamplesLoaded_ = 0;
}

void ReferenceSession::restrictTo(const render::PixelMask& mask) {
  mask_ = mask;
  coverage_.samples = render::FilmCoverage::kUneven;
}

void ReferenceSession::reset(std::uint32_t seed, std::uint32_t sampleCount) {
  settings_.image.seed = seed;
  settings_.image.sampleCount = sampleCount;
  tracer_->setSampling(seed, sampleCount);
  empty();
}

void ReferenceSession::setCamera(const scene::Camera& camera) {
  tracer_->setCamera(camera);
  prepareReplicas(camera);
  empty();
}

void ReferenceSession::setView(const scene::Camera& camera, const render::Extent& size) {
  if (settings_.image.crop) throw UsageError("a session that renders a crop has one size");
  settings_.image.size = size;
  film_ = guarded([&] { return render::emptyFilm(settings_.image, size); });
  tracer_->setSize(size);
  setCamera(camera);
}

void ReferenceSession::load(const image::Film& film, std::uint32_t first) {
  const render::FilmCoverage coverage = render::coverageOf(film, first, settings_.image.window().extent(),
                                                           settings_.image.sampleCount);
  render::requireSameSums(film, settings_.image);
  empty();
  film_ = film;
  coverage_ = coverage;
  badSamplesLoaded_ = film_.counts().badSamples;
}

bool ReferenceSession::advance(render::SampleRange range, const render::RenderControl& control) {
  const std::uint32_t covered = render::minSampleCount(film_.pixels());
  render::requireContiguous(range, coverage_, covered, settings_.image.sampleCount);
  if (coverage_.isEmpty()) coverage_.first = range.first;
  if (range.end <= coverage_.first + covered) return true;
  return guarded([&] {
    Stopwatch watch;
    const render::Extent tile = settings_.execution.tile.value_or(kDefaultTile);
    TileJob job(*tracer_, tile, range.end, control,
                {film_, settings_.image.window(), coverage_.first, paths_, replicas_,
                 replicaTracer_ ? &*replicaTracer_ : nullptr, settings_.execution.replicas, settings_.image.hasAlpha(),
                 matteIds_ ? &*matteIds_ : nullptr, mask_});
    addCounters(job.run(statistics_.threads));
    statistics_.seconds["trace"] += watch.lap();
    statistics_.tile = tile;
    const bool isUneven = job.wasInterrupted() || !mask_.empty();
    coverage_.samples = isUneven ? render::FilmCoverage::kUneven : range.end - coverage_.first;
    return !job.wasInterrupted();
  });
}

void ReferenceSession::addCounters(const Counters& counters) {
  statistics_.samples += counters.samples;
  statistics_.cameraRays += counters.cameraRays;
  statistics_.bounceRays += counters.bounceRays;
  statistics_.shadowRays += counters.shadowRays;
  statistics_.vertices += counters.vertices;
  statistics_.volumeFaults += counters.volumeFaults;
  statistics_.traversalSteps += counters.traversalSteps;
  if (settings_.image.integrator != render::Integrator::whitted) return;
  if (!statistics_.treeRays) statistics_.treeRays.emplace();
  statistics_.treeRays->cameraHits += counters.cameraHits;
  statistics_.treeRays->reflected += counters.reflectedRays;
  statistics_.treeRays->refracted += counters.refractedRays;
}

render::RenderStatistics ReferenceSession::statistics() {
  render::RenderStatistics result = statistics_;
  result.badSamples = film_.counts().badSamples - badSamplesLoaded_;
  return result;
}

std::vector<render::PathTrace> ReferenceSession::replayReplicas(const render::PixelSample& sample,
                                                                std::uint32_t count) {
  std::vector<render::PathTrace> traces;
  for (std::uint32_t i = 0; i < count; ++i) {
    RoundedArithmetic rounded = replicaTracer_->arithmeticOf(sample, i);
    traces.push_back(pathTracer_->trace(sample, rounded));
  }
  return traces;
}

render::Replay ReferenceSession::replay(const render::PixelSample& sample) {
  Arithmetic exact;
  return {pathTracer_->trace(sample, exact), prepared_};
}

}  // namespace candela::reference

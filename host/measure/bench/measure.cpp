// Measures whole renders, and compares their films.
#include "host/measure/bench/measure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "host/base/statistics/quantiles.h"
#include "host/image/metrics.h"

namespace candela::bench {
namespace {

using statistics::median;
using statistics::ratio;

void insertAscending(std::vector<double>& values, double value) {
  values.insert(std::upper_bound(values.begin(), values.end(), value), value);
}

void addRun(render::RenderStatistics statistics, std::uint64_t hash, Measurement& measurement) {
  const bool first = measurement.traceSeconds.empty();
  measurement.agrees &= first || hash == measurement.filmHash;
  if (first) measurement.pipelineSeconds = statistics.seconds["pipeline"];
  measurement.filmHash = hash;
  measurement.statistics = std::move(statistics);
  measurement.agrees &= measurement.statistics.truncated == 0;
  insertAscending(measurement.traceSeconds, measurement.statistics.seconds["trace"]);
}

// The sessions of all variants, made when they are first needed.
class Sessions {
 public:
  Sessions(render::Renderer& renderer, const scene::Scene& scene, Preparation preparation, std::size_t count)
      : renderer_(renderer), scene_(scene), preparation_(preparation), sessions_(count) {}

  /// The session of a variant, with an empty film.
  render::Session& get(std::size_t index, const render::RenderSettings& settings) {
    std::unique_ptr<render::Session>& session = sessions_[index];
    if (session) {
      session->reset(settings.image.seed, settings.image.sampleCount);
    } else {
      session = renderer_.prepare(scene_, settings);
    }
    return *session;
  }
  void release(std::size_t index) {
    if (preparation_ == Preparation::everyRun) sessions_[index].reset();
  }
  bool isPrepared(std::size_t index) const { return sessions_[index] != nullptr; }

 private:
  render::Renderer& renderer_;
  const scene::Scene& scene_;
  Preparation preparation_;
  std::vector<std::unique_ptr<render::Session>> sessions_;
};

// Number of runs that gave each film of an image.
using RunsByHash = std::map<std::uint64_t, std::uint32_t>;

// Returns the hash of the film that more than half of the runs gave, or 0 if there is none.
std::uint64_t commonHash(const RunsByHash& runsByHash) {
  std::uint32_t runs = 0;
  for (const auto& [hash, count] : runsByHash) runs += count;
  for (const auto& [hash, count] : runsByHash) {
    if (2 * count > runs) return hash;
  }
  return 0;
}

// Renders pictures with the seeds from `seed` on; none if `control` stops it.
std::vector<image::Image> picturesOf(render::Session& session, std::uint32_t seed, std::uint32_t count,
                                     std::uint32_t sampleCount, const render::RenderControl& control) {
  std::vector<image::Image> pictures;
  for (std::uint32_t i = 0; i < count; ++i) {
    session.reset(seed + i, sampleCount);
    if (!session.advance({0, sampleCount}, control)) return {};
    pictures.push_back(toImage(session.film()));
  }
  return pictures;
}

// Returns the relMSE of each of `count` pictures, or none if `control` stops it.
std::vector<double> relMseOfPictures(render::Renderer& renderer, const scene::Scene& scene,
                                     const render::RenderSettings& settings, std::uint32_t count,
                                     const render::RenderControl& control) {
  const std::unique_ptr<render::Session> session = renderer.prepare(scene, settings);
  const std::uint32_t samples = settings.image.sampleCount;
  const std::uint32_t most = std::min(samples, render::kMaxSampleCount / kReferenceSamples) * kReferenceSamples;
  const std::uint32_t seed = settings.image.seed + 1;
  const std::vector<image::Image> converged = picturesOf(*session, seed, count, most, control);
  if (converged.empty()) return {};
  const ErrorReference reference = errorReferenceOf(converged);
  std::vector<double> errors;
  for (const image::Image& picture : picturesOf(*session, seed + count, count, samples, control)) {
    errors.push_back(relMseOf(picture, reference));
  }
  return errors;
}

// Maps the progress of one run to that of all runs.
render::RenderControl partOf(const render::RenderControl& whole, std::uint32_t runsOver, std::uint32_t runs,
                             std::uint64_t samplesOver) {
  render::RenderControl part = whole;
  if (!whole.progress) return part;
  part.progress = [&whole, runsOver, runs, samplesOver](double fraction, std::uint64_t samples) {
    whole.progress((runsOver + fraction) / runs, samplesOver + samples);
  };
  return part;
}

}  // namespace

double Measurement::mraysPerSecond() const {
  return ratio(static_cast<double>(statistics.rays()) / 1e6, median(traceSeconds));
}

double Measurement::msamplesPerSecond() const {
  return ratio(static_cast<double>(statistics.samples) / 1e6, median(traceSeconds));
}

double Measurement::efficiency() const { return ratio(1, relMse.value_or(0) * median(traceSeconds)); }

double Measurement::stepsPerRay() const {
  return ratio(static_cast<double>(statistics.traversalSteps), static_cast<double>(statistics.rays()));
}

std::vector<Measurement> measureInterleaved(render::Renderer& renderer, const scene::Scene& scene,
                                            std::span<const Variant> variants, std::uint32_t repeats,
                                            const render::RenderControl& control, Preparation preparation) {
  const std::uint32_t runs = repeats * static_cast<std::uint32_t>(variants.size());
  std::vector<Measurement> measurements;
  for (const Variant& variant : variants) measurements.push_back({.variant = variant});
  Sessions sessions(renderer, scene, preparation, variants.size());
  std::map<std::string, RunsByHash> runsByImage;
  std::uint64_t samples = 0;
  for (std::uint32_t run = 0; run < runs; ++run) {
    const std::size_t index = run % variants.size();
    Measurement& measurement = measurements[index];
    const bool wasPrepared = sessions.isPrepared(index);
    render::Session& session = sessions.get(index, measurement.variant.settings);
    const std::optional<WarmUpWork> warmed = warmUp(session, measurement.variant.settings.image, control);
    if (!warmed) return {};
    measurement.warmUp.add(*warmed);
    const render::SampleRange all{0, measurement.variant.settings.image.sampleCount};
    if (!session.advance(all, partOf(control, run, runs, samples))) return {};
    render::RenderStatistics statistics = session.statistics();
    const std::uint64_t hash = session.film().hash();
    sessions.release(index);
    samples += statistics.samples;
    ++runsByImage[measurement.variant.image][hash];
    if (!wasPrepared) insertAscending(measurement.buildSeconds, statistics.seconds["structure"]);
    addRun(std::move(statistics), hash, measurement);
  }
  for (Measurement& measurement : measurements) {
    measurement.agrees &= measurement.filmHash == commonHash(runsByImage.at(measurement.variant.image));
  }
  return measurements;
}

bool measureNoise(render::Renderer& renderer, const scene::Scene& scene, std::span<Measurement> measurements,
                  const render::RenderControl& control) {
  render::RenderControl silent = control;  // the progress has reached its end
  silent.progress = nullptr;
  std::map<std::string, double> noiseOf;
  for (Measurement& measurement : measurements) {
    const Variant& variant = measurement.variant;
    if (!noiseOf.contains(variant.image)) {
      std::array<image::Image, 2> images;
      for (std::uint32_t i = 0; i < images.size(); ++i) {
        render::RenderSettings settings = variant.settings;
        settings.image.seed += 1 + i;
        const render::RenderResult result = renderer.render(scene, settings, silent);
        if (result.interrupted) return false;
        images[i] = toImage(result.film);
      }
      noiseOf[variant.image] = compareImages(images[0], images[1]).relativeMeanSquaredError / 2;
    }
    measurement.relMse = noiseOf[variant.image];
  }
  return true;
}

bool measureError(render::Renderer& renderer, const scene::Scene& scene, std::span<Measurement> measurements,
                  std::uint32_t pictureCount, const render::RenderControl& control) {
  render::RenderControl silent = control;  // the progress has reached its end
  silent.progress = nullptr;
  std::map<std::string, std::vector<double>> errorsOf;
  for (Measurement& measurement : measurements) {
    std::vector<double>& errors = errorsOf[measurement.variant.image];
    if (errors.empty()) {
      errors = relMseOfPictures(renderer, scene, measurement.variant.settings, pictureCount, silent);
      if (errors.empty()) return false;
    }
    measurement.relMse = statistics::summarise(errors).mean;
    measurement.error = errorInTime(errors, measurement.traceSeconds);
  }
  return true;
}

}  // namespace candela::bench

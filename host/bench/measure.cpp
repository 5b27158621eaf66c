#include "host/bench/measure.h"

#include <algorithm>
#include <map>

namespace candela::bench {
namespace {

double ratio(double numerator, double denominator) { return denominator > 0 ? numerator / denominator : 0; }

void insertAscending(std::vector<double>& values, double value) {
  values.insert(std::upper_bound(values.begin(), values.end(), value), value);
}

void addRun(RenderStatistics statistics, std::uint64_t hash, Measurement& measurement) {
  measurement.agrees &= measurement.traceSeconds.empty() || hash == measurement.filmHash;
  measurement.filmHash = hash;
  measurement.statistics = std::move(statistics);
  measurement.agrees &= measurement.statistics.truncated == 0;
  insertAscending(measurement.traceSeconds, measurement.statistics.seconds["trace"]);
  insertAscending(measurement.buildSeconds, measurement.statistics.seconds["structure"]);
}

// The image of most runs. Where images are equally frequent none of them is more credible than the others.
std::uint64_t commonHash(const std::map<std::uint64_t, std::uint32_t>& runsByHash, std::uint32_t runs) {
  for (const auto& [hash, count] : runsByHash) {
    if (2 * count > runs) return hash;
  }
  return 0;
}

// What the caller sees of one run: its share of all of them, behind those that are over.
RenderControl shareOf(const RenderControl& whole, std::uint32_t runsOver, std::uint32_t runs, std::uint64_t samplesOver) {
  RenderControl part = whole;
  if (!whole.progress) return part;
  part.progress = [&whole, runsOver, runs, samplesOver](double fraction, std::uint64_t samples) {
    whole.progress((runsOver + fraction) / runs, samplesOver + samples);
  };
  return part;
}

}  // namespace

double median(std::span<const double> ascending) {
  if (ascending.empty()) return 0;
  const std::size_t middle = ascending.size() / 2;
  return ascending.size() % 2 == 1 ? ascending[middle] : (ascending[middle - 1] + ascending[middle]) / 2;
}

double spread(std::span<const double> ascending) {
  return ascending.empty() ? 0 : ratio(ascending.back() - ascending.front(), median(ascending));
}

double Measurement::mraysPerSecond() const {
  return ratio(static_cast<double>(statistics.rays()) / 1e6, median(traceSeconds));
}

double Measurement::msamplesPerSecond() const {
  return ratio(static_cast<double>(statistics.samples) / 1e6, median(traceSeconds));
}

double Measurement::stepsPerRay() const {
  return ratio(static_cast<double>(statistics.traversalSteps), static_cast<double>(statistics.rays()));
}

std::vector<Measurement> measureInterleaved(Renderer& renderer, const Scene& scene, std::span<const Variant> variants,
                                            std::uint32_t repeats, const RenderControl& control) {
  const std::uint32_t runs = repeats * static_cast<std::uint32_t>(variants.size());
  std::vector<Measurement> measurements;
  for (const Variant& variant : variants) measurements.push_back({.variant = variant});
  std::map<std::uint64_t, std::uint32_t> runsByHash;
  std::uint64_t samples = 0;
  for (std::uint32_t run = 0; run < runs; ++run) {
    Measurement& measurement = measurements[run % variants.size()];
    RenderResult result =
        renderer.render(scene, measurement.variant.settings, shareOf(control, run, runs, samples));
    if (result.interrupted) return {};
    samples += result.statistics.samples;
    const std::uint64_t hash = result.film.hash();
    ++runsByHash[hash];
    addRun(std::move(result.statistics), hash, measurement);
  }
  const std::uint64_t common = commonHash(runsByHash, runs);
  for (Measurement& measurement : measurements) measurement.agrees &= measurement.filmHash == common;
  return measurements;
}

}  // namespace candela::bench

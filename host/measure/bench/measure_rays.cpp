// Measures the tracing of rays, and compares their hits.
#include "host/measure/bench/measure_rays.h"

#include <sys/resource.h>

#include <algorithm>

#include "host/base/statistics/quantiles.h"
#include "host/measure/bench/measure.h"

namespace candela::bench {
namespace {

double processorSeconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double rate(std::uint64_t rays, double seconds) { return seconds > 0 ? 1e-6 * static_cast<double>(rays) / seconds : 0; }

double equalFractionOf(std::span<const gpu::CastHit> a, std::span<const gpu::CastHit> b, bool exactly) {
  std::size_t same = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    same += a[i].found.y == b[i].found.y && (!exactly || a[i].found.x == b[i].found.x);
  }
  return static_cast<double>(same) / static_cast<double>(a.size());
}

double meanSteps(std::span<const gpu::CastHit> hits) {
  double sum = 0;
  for (const gpu::CastHit& hit : hits) sum += hit.found.z;
  return sum / static_cast<double>(hits.size());
}

void warmUp(RayTracer& tracer, RayMeasurement& measurement, const std::atomic<bool>* stop) {
  WarmUp warmUp;
  while (!warmUp.isDone() && (stop == nullptr || !*stop)) {
    warmUp.add(tracer.trace(), static_cast<double>(measurement.rayCount));
  }
  measurement.warmUp.add(warmUp.work());
}

void time(RayTracer& tracer, RayMeasurement& measurement) {
  const double before = processorSeconds();
  measurement.seconds.push_back(tracer.trace());
  measurement.processorSeconds.push_back(processorSeconds() - before);
}

// Loads the rays, traces them once, so that the driver compiles, and compares the hits with those of the first tracer.
std::vector<RayMeasurement> prepare(std::span<RayTracer* const> tracers, std::span<const gpu::CastRay> rays,
                                    std::uint32_t kind) {
  std::vector<RayMeasurement> measurements;
  std::vector<gpu::CastHit> expected;
  for (RayTracer* const tracer : tracers) {
    tracer->load(rays, kind == gpu::kShadowRay);
    tracer->trace();
    std::vector<gpu::CastHit> hits = tracer->hits();
    if (expected.empty()) expected = hits;
    measurements.push_back({kind, rays.size(), meanSteps(hits), equalFractionOf(hits, expected, tracer->isExact())});
  }
  return measurements;
}

}  // namespace

const char* rayKindName(std::uint32_t kind) {
  if (kind == gpu::kPrimaryRay) return "primary";
  return kind == gpu::kDiffuseRay ? "diffuse" : "shadow";
}

double RayMeasurement::mraysPerSecond() const { return rate(rayCount, statistics::median(seconds)); }

double RayMeasurement::mraysPerProcessorSecond() const { return rate(rayCount, statistics::median(processorSeconds)); }

std::vector<RayMeasurement> measureRays(std::span<RayTracer* const> tracers, const device::RaySets& sets,
                                        std::uint32_t repeats, const std::atomic<bool>* stop) {
  std::vector<RayMeasurement> all;
  for (std::uint32_t kind = 0; kind < sets.size(); ++kind) {
    if (sets[kind].empty()) continue;
    std::vector<RayMeasurement> measurements = prepare(tracers, sets[kind], kind);
    for (std::uint32_t run = 0; run < repeats; ++run) {
      for (std::size_t i = 0; i < tracers.size(); ++i) {
        if (tracers[i]->needsWarmUp()) warmUp(*tracers[i], measurements[i], stop);
        if (stop != nullptr && *stop) return {};
        time(*tracers[i], measurements[i]);
      }
    }
    for (RayMeasurement& measurement : measurements) {
      std::sort(measurement.seconds.begin(), measurement.seconds.end());
      std::sort(measurement.processorSeconds.begin(), measurement.processorSeconds.end());
      all.push_back(std::move(measurement));
    }
  }
  return all;
}

}  // namespace candela::bench

// Traces rays of a scene without the rest of their paths, by kind and layout, interleaved, so that noise of the machine
// affects all equally.
#pragma once
#include <atomic>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "host/measure/bench/warm_up.h"
#include "host/trace/device/ray_caster.h"

namespace candela::bench {

/// Returns the name of a kind of rays such as kPrimaryRay: "primary", "diffuse", "shadow".
const char* rayKindName(std::uint32_t kind);

/// Traces given rays: a device with one layout, or another program that is compared with it.
class RayTracer {
 public:
  virtual ~RayTracer() = default;
  /// Replaces the rays; see RayCaster::load.
  virtual void load(std::span<const gpu::CastRay> rays, bool anyHit) = 0;
  /// Traces the rays once. Returns seconds of wall-clock time.
  virtual double trace() = 0;
  /// Returns the results of the last trace. Steps are 0 if the tracer does not count them.
  virtual std::vector<gpu::CastHit> hits() = 0;
  /// Returns whether distances must equal those of the first tracer to the last bit; otherwise only primitives are
  /// compared.
  virtual bool isExact() const { return true; }
  /// Returns whether each timed run follows a warm-up, because the clock of a GPU falls while it has nothing to do.
  virtual bool needsWarmUp() const { return false; }
};

/// Measurements of rays of one kind with one tracer.
struct RayMeasurement {
  std::uint32_t kind = gpu::kPrimaryRay;
  std::uint64_t rayCount = 0;
  double stepsPerRay = 0;
  double equalFraction = 1;                ///< fraction of rays whose hits equal those of the first tracer
  std::vector<double> seconds{};           ///< one per run, ascending
  std::vector<double> processorSeconds{};  ///< user and system time of this process, ascending
  WarmUpWork warmUp{};                     ///< before all runs together

  double mraysPerSecond() const;  ///< at the median time
  double mraysPerProcessorSecond() const;
};

/// Measures every kind of rays with every tracer: one run for compilation and comparison of the hits, then `repeats`
/// interleaved runs, each after a warm-up if the tracer needs one. The order is by kind, then by tracer. Returns
/// nothing if `stop` became true.
std::vector<RayMeasurement> measureRays(std::span<RayTracer* const> tracers, const device::RaySets& sets,
                                        std::uint32_t repeats, const std::atomic<bool>* stop);

}  // namespace candela::bench

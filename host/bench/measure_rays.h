// Traces the rays of a scene alone, by kind and by layout, in turn, so that a noisy machine hurts all alike.
#pragma once
#include <atomic>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "host/device/ray_caster.h"

namespace candela::bench {

/// Name of a kind of rays, kPrimaryRay and so on: "primary", "diffuse", "shadow".
const char* rayKindName(std::uint32_t kind);

/// What traces given rays: a device through one layout, or a peer that is compared with it.
class RayTracer {
 public:
  virtual ~RayTracer() = default;
  /// Puts rays in the place of those before; see RayCaster::load.
  virtual void load(std::span<const gpu::CastRay> rays, bool anyHit) = 0;
  /// Traces them once; seconds by the clock.
  virtual double trace() = 0;
  /// Of the last trace. A peer that counts no steps leaves them 0.
  virtual std::vector<gpu::CastHit> hits() = 0;
  /// Whether distances are the first tracer's to the last bit; if not, primitives alone are compared.
  virtual bool isExact() const { return true; }
};

/// Rays of one kind through one tracer.
struct RayMeasurement {
  std::uint32_t kind = gpu::kPrimaryRay;
  std::uint64_t rayCount = 0;
  double stepsPerRay = 0;
  double share = 1;                        ///< of rays whose hits are those of the first tracer
  std::vector<double> seconds{};           ///< one per run, ascending
  std::vector<double> processorSeconds{};  ///< of this process, user and system, ascending

  double mraysPerSecond() const;  ///< at the median time
  double mraysPerProcessorSecond() const;
};

/// Every kind of rays there is, through every tracer: first once to warm up and to compare hits, then `repeats` times,
/// all tracers once before any twice. By kind, then in the order of tracers; nothing if `stop` became true.
std::vector<RayMeasurement> measureRays(std::span<RayTracer* const> tracers, const device::RaySets& sets,
                                        std::uint32_t repeats, const std::atomic<bool>* stop);

}  // namespace candela::bench

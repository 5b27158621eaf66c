// Stochastic arithmetic: the quantities of the reference with the rounding errors of single precision on a device.
//
// A replica is a sample traced again with each quantity moved by its bound (RoundingBounds), up or down with equal
// probability, independently of the others (CESTAC: Vignes, "A stochastic arithmetic for reliable scientific
// computation", 1993; Verrou: Fevotte and Lathuiliere, 2016). Of all errors within a bound this one has the largest
// variance, so that replicas spread at least as far as a conforming device does.
#pragma once
#include <vector>

#include "host/trace/reference/arithmetic.h"
#include "host/trace/reference/rounding/bounds.h"
#include "host/trace/reference/rounding/rounded_tracing.h"

namespace candela::reference {

/// One ray of a path or tree, as far as the comparison of replicas needs it.
struct TrailVertex {
  dvec3 origin;
  dvec3 direction;
  std::uint64_t decisions;  ///< hash of all decisions before this vertex
};

/// Exact arithmetic that records the rays of a sample, and a hash of its decisions.
class RecordedArithmetic : public Arithmetic {
 public:
  Hit closest(const Tracing& tracing, std::uint32_t vertex, Ray& ray, Counters& counters) override;
  void decide(std::uint64_t choice) override;
  /// Light too faint to count is none, and neither is light at the horizon, such as that of a light in the plane of the
  /// surface.
  void decideLit(const dvec3& radiance, double cosine) override;

  std::uint64_t decisions() const { return decisions_; }
  const std::vector<TrailVertex>& trail() const { return trail_; }

 protected:
  void record(const Ray& ray) { trail_.push_back({ray.origin, ray.direction, decisions_}); }

 private:
  std::uint64_t decisions_ = 0;
  std::vector<TrailVertex> trail_;
};

/// The arithmetic of one replica.
class RoundedArithmetic final : public RecordedArithmetic {
 public:
  /// `key` names seed, pixel, sample and replica. `tracing` must outlive the object.
  RoundedArithmetic(const RoundedTracing& tracing, std::uint64_t key);

  Ray cameraRay(const Ray& ray, bool originVaries) override;
  Hit closest(const Tracing& tracing, std::uint32_t vertex, Ray& ray, Counters& counters) override;
  bool isOccluded(const Tracing& tracing, const Ray& ray, const RayEnd& end, Counters& counters) override;
  Surface surfaceAt(const scene::Scene& scene, const Ray& ray, const Hit& hit) override;
  dvec2 texCoords(const std::optional<scene::TextureReference>& texture, const MeshAttributes& attributes) override;

  dvec3 direction(const dvec3& direction) override { return turned(direction, kRoundingBounds.frame); }
  dvec3 mapDirection(const dvec3& direction) override { return turned(direction, kRoundingBounds.mapDirection); }
  dvec3 sampledDirection(const dvec3& direction) override {
    return normalize(relative(direction, kRoundingBounds.sampledDirection));
  }
  dvec3 microfacetDirection(const dvec3& direction, double alpha) override {
    return turned(direction, kRoundingBounds.frame + alpha * kRoundingBounds.roughDirection);
  }
  dvec3 lightDirection(const dvec3& direction) override { return turned(direction, kRoundingBounds.lightDirection); }
  double lightDistance(double distance) override { return relative(distance, kRoundingBounds.lightDistance); }
  LightSample lightSample(const LightSample& light) override;

  double importance(double importance, double condition) override {
    return relative(importance, condition * kRoundingBounds.importance);
  }
  double cosineOfImportance(double cosine, double condition) override {
    return absolute(cosine, condition * kRoundingBounds.importanceCosine);
  }

  double choice(double number) override { return absolute(number, kRoundingBounds.choice); }
  double lobeChoice(double number) override { return absolute(number, kRoundingBounds.lobeChoice); }
  double pdf(double pdf) override { return relative(pdf, kRoundingBounds.pdf); }
  BsdfValue bsdfValue(const BsdfValue& value, const Bsdf& bsdf) override;
  double reflectance(double reflectance) override { return relative(reflectance, kRoundingBounds.bsdf); }
  dvec3 reflectance(const dvec3& reflectance) override { return relative(reflectance, kRoundingBounds.bsdf); }
  dvec3 throughput(const dvec3& factor) override { return relative(factor, kRoundingBounds.throughput); }
  double survival(double probability) override { return relative(probability, kRoundingBounds.survival); }
  dvec3 radiance(const dvec3& radiance) override { return relative(radiance, kRoundingBounds.radiance); }

 private:
  /// Begins the random signs of a vertex or node; 0 is the camera.
  void startVertex(std::uint32_t vertex);
  RayErrors rayErrors();
  std::uint64_t nextWord();
  double sign();
  dvec3 signs() { return {sign(), sign(), sign()}; }

  double absolute(double value, double units) { return value + sign() * units * kRoundoff; }
  double relative(double value, double units) { return value * (1 + sign() * units * kRoundoff); }
  dvec3 relative(const dvec3& value, double units);
  /// Moves a vector by `units` of `scale` on each axis.
  dvec3 moved(const dvec3& value, double units, double scale) { return value + units * kRoundoff * scale * signs(); }
  /// Turns a unit vector, which stays one.
  dvec3 turned(const dvec3& direction, double units) { return normalize(direction + units * kRoundoff * signs()); }

  const RoundedTracing& tracing_;
  std::uint64_t key_;
  std::uint64_t counter_;
  std::uint64_t bits_ = 0;
  std::uint32_t bitCount_ = 0;
};

}  // namespace candela::reference

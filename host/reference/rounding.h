// Stochastic arithmetic: perturbs the values of the reference by the rounding errors of single precision on a device.
//
// A replica is a sample traced again with each quantity moved by its bound (RoundingBounds), up or down with equal
// probability, independently of the others (CESTAC: Vignes, "A stochastic arithmetic for reliable scientific
// computation", 1993; Verrou: Fevotte and Lathuiliere, 2016). Of all errors within a bound this one has the largest
// variance, so that replicas spread at least as far as a conforming device does.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "host/reference/bsdf.h"
#include "host/reference/light.h"
#include "host/reference/ray.h"
#include "host/reference/surface.h"

namespace candela::reference {

/// Relative error of one correctly rounded operation in single precision.
inline constexpr double kRoundoff = 0x1p-24;

/// Bounds in units of kRoundoff, each the root of the sum of the squares of the bounds of the operations that compute
/// the quantity in `shaders/`. Vulkan's precision ("Precision and Operation of SPIR-V Instructions"): 1 for + - *, 5
/// for a division (2.5 ulp), 4 for inversesqrt, hence 6.4 for sqrt (1 / inversesqrt). docs/testing.md has the table.
struct RoundingBounds {
  double cameraDirection = 5;  ///< of a unit vector, per axis: three rounded axes of the view, products, sums, one
                               ///< division
  double lensPoint = 5;        ///< relative, per axis
  double triangleTest = 6;     ///< of the farthest vertex: differences, shear (a division), products of coordinates
  double sphereTest = 4;       ///< of the distance to the anchor: differences, products, sums
  double boxTest = 6;          ///< of the farthest corner: differences, reciprocal of the direction
  double coneTest = 8;         ///< of the distance to the base plus the height: axis, products, sums
  double planeTest = 3;        ///< of the distance to the plane's point: difference, products, sums
  double hitDistance = 8;      ///< relative: quotient of the last step, between primitives at equal distances
  double position = 6;         ///< of the largest coordinate or distance: o + t d, put back onto the primitive, offset
  double normal = 3;           ///< of a unit vector, per axis, apart from the position's error
  double texCoord = 9;  ///< of the sum of the magnitudes of its terms and 1: interpolation (a division), transform
  double frame = 4;     ///< of a direction turned into or out of the shading frame, per axis
  double sampledDirection = 6;  ///< relative, per local axis: roots of the warps
  double lightDirection = 3;    ///< of a unit vector, per axis
  double lightDistance = 7;     ///< relative: a square root
  double lightDepth = 12;       ///< of the largest coordinate: distance of a light from a surface that it may touch
  double mapDirection = 8;      ///< of a unit vector, per axis: its coordinates in the environment's map
  double pdf = 12;              ///< relative: products and two divisions
  double bsdf = 12;             ///< relative
  double surface = 18;          ///< relative, f and pdf of surfaces: energy, distribution and visibility
  double sheen = 6;             ///< relative, of the quotient that sheen raises to a power
  double film = 0.1;            ///< relative, per nanometre of a thin film: product with the frequency, sums
  double choice = 6;            ///< of a probability that a random number is compared with
  double surfaceChoice = 14;    ///< of the probability of a surface's lobe: quotient of albedos
  double roughDirection = 16;   ///< of a direction sampled by microfacets, per axis, times alpha, besides `frame`
  double throughput = 8;        ///< relative: quotient of f and pdf
  double survival = 7;          ///< relative: a square root
  double radiance = 2;          ///< relative: a product and a sum
};
inline constexpr RoundingBounds kRoundingBounds{};

/// Largest coordinate, without its sign.
inline double maxNorm(const dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// One ray or node of a path, as far as the comparison of replicas needs it.
struct TrailVertex {
  dvec3 origin;
  dvec3 direction;
  std::uint64_t decisions;  ///< hash of all decisions before this vertex
};

/// Perturbs the quantities of one replica, and hashes its decisions. Does nothing unless it was given a replica.
class Rounding {
 public:
  /// Off: every function returns its argument, and nothing is recorded.
  Rounding() = default;
  /// Replica 0 computes exactly and records decisions. `key` names seed, pixel and sample.
  Rounding(std::uint64_t key, std::uint32_t replica);

  bool records() const { return records_; }
  bool perturbs() const { return perturbs_; }

  /// Begins the random signs and the record of a vertex or node.
  void startVertex(std::uint32_t vertex, const Ray& ray);
  void decide(std::uint64_t choice) {
    if (records_) decisions_ = (decisions_ ^ choice) * 0x9fb21c651e98df25u, decisions_ ^= decisions_ >> 32;
  }

  /// The decision that light arrives, with this cosine at the surface. Light too faint to count is none, and neither is
  /// light at the horizon, such as that of a light in the plane of the surface.
  void decideLit(const dvec3& radiance, double cosine) {
    if (records_ && maxNorm(radiance) > kNegligible && cosine > kHorizon) decide(kLit);
  }

  double relative(double value, double units) { return perturbs_ ? value * (1 + sign() * units * kRoundoff) : value; }
  dvec3 relative(const dvec3& value, double units);
  double absolute(double value, double units) { return perturbs_ ? value + sign() * units * kRoundoff : value; }
  /// Moves a vector by `units` of `scale` on each axis.
  dvec3 moved(const dvec3& value, double units, double scale);
  /// Turns a unit vector, which stays one.
  dvec3 turned(const dvec3& direction, double units);

  dvec3 signs() { return {sign(), sign(), sign()}; }
  std::uint64_t word() { return nextWord(); }
  /// The sign of an error of one primitive among those that a ray tests; `word` is the ray's.
  static double signOf(std::uint64_t word, std::uint32_t primitive);

  /// The camera's ray. `originVaries`: its origin is computed, on a lens or on the plane of an orthographic camera.
  Ray cameraRay(Ray ray, bool originVaries);
  /// The surface that `ray` hits, with the position and normals of single precision.
  Surface surfaceAt(const scene::Scene& scene, Ray ray, const Hit& hit);

  std::optional<LightSample> lightSample(std::optional<LightSample> light);
  BsdfValue bsdfValue(BsdfValue value, double units);
  /// In the shading frame.
  dvec3 sampledDirection(const dvec3& local) {
    return perturbs_ ? normalize(relative(local, kRoundingBounds.sampledDirection)) : local;
  }
  /// A direction that microfacets of this alpha reflect or refract, in the shading frame.
  dvec3 microfacetDirection(const dvec3& local, double alpha) {
    return turned(local, kRoundingBounds.frame + alpha * kRoundingBounds.roughDirection);
  }

  std::uint64_t decisions() const { return decisions_; }
  const std::vector<TrailVertex>& trail() const { return trail_; }

 private:
  static constexpr double kNegligible = 0x1p-26;
  static constexpr double kHorizon = 0x1p-18;  // several times the error of a direction's cosine
  static constexpr std::uint64_t kLit = 0x6c69676874u;

  void startVertex(std::uint32_t vertex);
  std::uint64_t nextWord();
  double sign();

  bool records_ = false;
  bool perturbs_ = false;
  std::uint64_t key_ = 0;
  std::uint64_t counter_ = 0;
  std::uint64_t bits_ = 0;
  std::uint32_t bitCount_ = 0;
  std::uint64_t decisions_ = 0;
  std::vector<TrailVertex> trail_;
};

}  // namespace candela::reference

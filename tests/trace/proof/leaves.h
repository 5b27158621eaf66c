// The functions under test, of one side. A program that is linked with reference_leaves.cpp tests those of the
// reference, and one with device_leaves.cpp those of the device; the proofs are the same.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <vector>

#include "host/trace/render/renderer.h"

namespace candela::proof {

using glm::dvec2;
using glm::dvec3;

/// Relative rounding of this side's numbers, with room for a few dozen operations.
extern const double kRounding;

/// Renders on this side; a device must not have truncated a loop.
render::RenderResult renderScene(const scene::Scene& scene, const render::RenderSettings& settings);

/// Applies the warps of docs/light-transport.md section 2 to pairs of numbers (tent and Gaussian: to the first).
struct WarpValues {
  std::vector<dvec2> disc;
  std::vector<dvec2> triangle;  ///< weights of the second and the third corner
  std::vector<dvec3> cap;
  std::vector<dvec3> cosineHemisphere;
  std::vector<double> tent;
  std::vector<double> gaussian;
};
WarpValues warps(std::span<const glm::vec3> numbers, float capHeight);

/// The throughput and the random number that choose the channel at a surface with dispersion.
struct ChannelQuery {
  glm::vec3 throughput{1};
  float number = 0.5f;

  bool operator==(const ChannelQuery&) const = default;
};
/// Scattering at a point of a material, in the local frame of the normal.
struct ScatterQuery {
  std::uint32_t material = 0;
  dvec3 wo{0, 0, 1};
  glm::vec3 numbers{0};  ///< lobe, bsdf u, v
  bool outside = true;   ///< wo is on the side to which the surface is oriented
  ChannelQuery dispersion{};
  dvec3 geometric{0};  ///< as in DirectionPair
};
struct Scattered {
  render::Lobe lobe = render::Lobe::none;  ///< none: the path ends
  dvec3 wi{0};
  dvec3 weight{0};  ///< f |cos| / pdf; 0 where the path ends
  double pdf = 0;   ///< per solid angle, of all smooth lobes; 0: a discrete choice
};
struct DirectionPair {
  std::uint32_t material = 0;
  dvec3 wo{0, 0, 1};
  dvec3 wi{0, 0, 1};
  bool outside = true;
  ChannelQuery dispersion{};
  /// 0, or the geometric normal on the side of wo: the local frame is that of a normal map, and wo as its facet sees
  /// it.
  dvec3 geometric{0};
};
struct ScatterValue {
  dvec3 f{0};  ///< with a normal map, what takes the place of f |cos|, divided by the cosine to the geometric normal
  double pdf = 0;
};
class MaterialLeaves {
 public:
  explicit MaterialLeaves(const std::vector<scene::Material>& materials);
  ~MaterialLeaves();
  std::vector<Scattered> sample(std::span<const ScatterQuery> queries) const;
  std::vector<ScatterValue> evaluate(std::span<const DirectionPair> pairs) const;

 private:
  struct Side;
  std::unique_ptr<Side> side_;
};

/// A point from which lights are seen; `onLight`: it lies on the light's own surface.
struct Viewpoint {
  dvec3 position{0};
  bool onLight = false;
};
struct LitPoint {
  dvec3 wi{0};
  double distance = 0;
  double pdf = 0;  ///< per solid angle, times the probability of the choice (a point light: that alone); 0: no light
  dvec3 emission{0};
};
struct FoundLight {
  double distance = 0;  ///< 0: the ray does not hit it
  double pdf = 0;       ///< with which light samples find it
};
struct ChosenLight {
  std::uint32_t entry = 0;
  double probability = 0;
  std::uint32_t primitive = 0;  ///< of the choice by a tree, if it is an emitter
};
/// The light table of a scene. Its entries are numbered as in docs/light-transport.md section 6.
class LightLeaves {
 public:
  explicit LightLeaves(const scene::Scene& scene);
  ~LightLeaves();
  std::vector<ChosenLight> choose(std::span<const std::uint32_t> words) const;
  /// Numbers: light u, v in x and y.
  std::vector<LitPoint> sample(std::uint32_t entry, const Viewpoint& from, std::span<const glm::vec3> numbers) const;
  /// Traces rays, and returns those that hit the emitter of `entry`.
  std::vector<FoundLight> find(std::uint32_t entry, const Viewpoint& from, std::span<const dvec3> directions) const;

 private:
  struct Side;
  std::unique_ptr<Side> side_;
};

/// A point for which lights are chosen, with a normal of length 1.
struct ReceiverQuery {
  dvec3 position{0};
  dvec3 normal{0, 0, 1};
  bool transmits = false;
};
/// The choice of lights by a tree, with the independent numbers of seed 0.
class LightTreeLeaves {
 public:
  explicit LightTreeLeaves(const scene::Scene& scene, bool oneSided = false);
  ~LightTreeLeaves();
  /// Chooses with the numbers of vertex 1 of samples 0 to count - 1 of pixel 0.
  std::vector<ChosenLight> choose(const ReceiverQuery& receiver, std::uint32_t count) const;
  /// Returns the probabilities with which these primitives, which emit, are chosen.
  std::vector<double> probabilities(const ReceiverQuery& receiver, std::span<const std::uint32_t> primitives) const;

 private:
  struct Side;
  std::unique_ptr<Side> side_;
};

/// Numbers of a light sample of an environment: words of light u and v, and the place around the texel.
struct EnvironmentQuery {
  std::uint32_t wordU = 0;
  std::uint32_t wordV = 0;
  glm::vec2 place{0.5f};
};
struct EnvironmentTap {
  dvec3 radiance{0};
  double pdf = 0;  ///< with which light samples choose direction and tap, with the choice of the light
};
/// The environment of a scene that has one.
class EnvironmentLeaves {
 public:
  explicit EnvironmentLeaves(const scene::Scene& scene);
  ~EnvironmentLeaves();
  /// The distance is not set.
  std::vector<LitPoint> sample(std::span<const EnvironmentQuery> queries) const;
  /// Taps of directions, with as many pairs of numbers.
  std::vector<EnvironmentTap> tap(std::span<const dvec3> directions, std::span<const glm::vec3> jitter) const;

 private:
  struct Side;
  std::unique_ptr<Side> side_;
};

/// Single precision, so that both sides trace the same rays.
struct ProofRay {
  glm::vec3 origin;
  glm::vec3 direction;  ///< unit except for rounding
};
struct TracedHit {
  static constexpr std::uint32_t kMiss = 0xffffffffu;
  double distance = 0;
  std::uint32_t primitive = kMiss;
};
/// Closest hits through the default structure.
class RayLeaves {
 public:
  explicit RayLeaves(const scene::Scene& scene);
  ~RayLeaves();
  std::vector<TracedHit> closest(std::span<const ProofRay> rays) const;

 private:
  struct Side;
  std::unique_ptr<Side> side_;
};

}  // namespace candela::proof

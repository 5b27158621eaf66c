// Everything that the path of one sample computed, vertex by vertex, in a format that both tracers produce.
#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "host/trace/render/path_record.h"

namespace candela::render {

/// One sample of one pixel. `x` to the right and `y` down, all from 0.
struct PixelSample {
  std::uint32_t x = 0;
  std::uint32_t y = 0;
  std::uint32_t index = 0;

  bool operator==(const PixelSample&) const = default;
};

/// The point at which the ray hit a surface. Unit normals on the ray's side.
struct HitTrace {
  std::uint32_t primitive = 0;  ///< index in Scene::primitives
  std::uint32_t material = 0;   ///< index in Scene::materials
  double distance = 0;
  glm::dvec3 position{0};
  glm::dvec3 normal{0};  ///< geometric
  glm::dvec3 shadingNormal{0};
  bool fromOutside = true;  ///< the ray arrives on the side of the primitive's own normal
};

/// Emission of a surface that the path itself hit.
struct EmissionTrace {
  glm::dvec3 radiance{0};  ///< times `weight`, before the throughput
  double weight = 1;       ///< of multiple importance sampling
};

/// One light sample.
struct LightTrace {
  static constexpr std::uint32_t kPointLight = 0xffffffffu;
  std::uint32_t entry = 0;                ///< index in the light table: docs/light-transport.md section 6
  std::uint32_t primitive = kPointLight;  ///< of the light, or kPointLight
  ShadowOutcome shadow = ShadowOutcome::notTraced;
  // Defined if a shadow ray was traced:
  glm::dvec3 direction{0};  ///< unit, towards the light
  double distance = 0;      ///< to the sampled point
  double pdf = 0;      ///< per solid angle, with the choice of the light; a point light: probability of the choice only
  double bsdfPdf = 0;  ///< with which BSDF sampling would have chosen the direction
  // Defined if the shadow ray was unoccluded:
  double weight = 0;       ///< of multiple importance sampling
  glm::dvec3 radiance{0};  ///< contribution of the sample, before the throughput
};

/// The continuation of the path from a vertex.
struct ScatteringTrace {
  Lobe lobe = Lobe::none;
  glm::dvec3 direction{0};  ///< unit
  double pdf = 0;           ///< per solid angle; 0: delta
  glm::dvec3 weight{0};     ///< f |cos| / pdf
};

struct RouletteTrace {
  double probability = 1;  ///< of survival
  bool survived = true;
};

/// One vertex, from the arriving ray to the next one. Stages that the path did not reach are absent.
struct VertexTrace {
  glm::dvec3 origin{0};
  glm::dvec3 direction{0};                 ///< unit
  double pdf = 0;                          ///< of the direction, per solid angle; 0: delta
  glm::dvec3 throughput{1};                ///< of the ray
  std::array<std::uint32_t, 7> numbers{};  ///< words of the vertex's block, in the order of shaders/shared/dimensions.h
  std::optional<HitTrace> hit;             ///< absent: the ray hit nothing
  std::optional<EmissionTrace> emission;
  std::optional<LightTrace> light;
  std::optional<ScatteringTrace> scattering;  ///< absent: absorbed, or at the depth limit
  std::optional<RouletteTrace> roulette;
  glm::dvec3 radiance{0};  ///< of the path so far, this vertex included
};

struct PathTrace {
  static constexpr std::uint32_t kMaxVertices = 64;
  std::array<std::uint32_t, 4> cameraNumbers{};  ///< words of filter x, filter y, lens u, lens v
  std::vector<VertexTrace> vertices;             ///< the first kMaxVertices
  std::uint32_t vertexCount = 0;                 ///< of the whole path; a ray that hits nothing ends in a vertex too
  glm::dvec3 radiance{0};                        ///< the value of the sample, as added to the film
};

}  // namespace candela::render

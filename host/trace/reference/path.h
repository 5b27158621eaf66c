// The estimator: docs/light-transport.md section 7.
#pragma once
#include <optional>

#include "host/scene/scene.h"
#include "host/trace/reference/background.h"
#include "host/trace/reference/environment_map.h"
#include "host/trace/reference/lights.h"
#include "host/trace/reference/pixel_tracer.h"
#include "host/trace/reference/shading.h"
#include "host/trace/reference/surface.h"
#include "host/trace/render/settings.h"

namespace candela::reference {

class PathTracer final : public PixelTracer {
 public:
  /// The scene, which has a camera, must outlive the object.
  PathTracer(const scene::Scene& scene, const render::RenderSettings& settings);

  /// Computes the same as sample() for the same sample and arithmetic, and returns all intermediate results.
  render::PathTrace trace(const render::PixelSample& sample, Arithmetic& arithmetic) const;

 private:
  struct Path;
  struct Vertex;

  dvec3 radiance(const Ray& ray, SampleState& state) const override;
  dvec3 tracePath(Path& path) const;

  // The stages of the specification.

  /// Traces the ray. If it hits nothing, the path ends in the background.
  Hit arrive(Path& path) const;
  /// Adds the emission of the surface.
  void emit(Path& path, const Vertex& vertex) const;
  /// Adds the light of one entry of the light table.
  void light(Path& path, const Shading& shading) const;
  /// Chooses the next ray. Returns false if the path has ended.
  static bool scatter(Path& path, const Shading& shading);
  /// Plays Russian roulette. Returns false if the path has ended.
  bool roulette(Path& path) const;

  /// Returns the radiance of a ray that hits nothing, times its weight. Camera rays see the backdrop.
  dvec3 background(const Path& path) const;
  /// Returns a contribution to the path, which is darkened if light that was scattered `scatterings` times has a limit.
  dvec3 limited(const dvec3& contribution, std::uint32_t scatterings) const;
  Surface surfaceAt(const Path& path, const Hit& hit) const;
  /// Notes a hit, also for the layers if they show it.
  void noteHit(Path& path, const Vertex& vertex) const;
  dvec3 emission(const Path& path, const Vertex& vertex) const;
  /// Chooses the channel by which a direction is sampled; nothing if the surface does not disperse light.
  /// The density with which light sampling at the start of the ray would have chosen the hit.
  double pdfByLights(const Path& path, const Vertex& vertex) const;
  std::optional<ChannelChoice> channelAt(const Path& path, const Surface& surface) const;
  /// Returns a sample of an entry of the light table as seen from a surface.
  std::optional<LightSample> sampleLight(const Path& path, const LightChoice& choice, const Surface& surface) const;
  dvec3 directLight(const Path& path, const Shading& shading) const;

  render::RenderSettings settings_;
  Background background_;
  std::optional<EnvironmentMap> environment_;
  LightTable lights_;
};

}  // namespace candela::reference

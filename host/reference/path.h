// The estimator: docs/light-transport.md section 7.
#pragma once
#include <optional>

#include "host/reference/background.h"
#include "host/reference/bsdf.h"
#include "host/reference/environment_map.h"
#include "host/reference/lights.h"
#include "host/reference/path_notes.h"
#include "host/reference/pixel_tracer.h"
#include "host/reference/surface.h"
#include "host/render/settings.h"
#include "host/scene/scene.h"

namespace candela::reference {

struct VertexNumbers;
class Volumes;

class PathTracer final : public PixelTracer {
 public:
  /// The scene, which has a camera, must outlive the object.
  PathTracer(const scene::Scene& scene, const render::RenderSettings& settings);

  /// Computes the same as sample() for the same sample and replica (0: exactly), and returns all intermediate
  /// results.
  render::PathTrace trace(const render::PixelSample& sample, std::uint32_t replica = 0) const;

 private:
  /// A surface with its material's frame.
  struct Vertex;
  /// The continuation of a path; `pdf` is none for a delta lobe. A weight of 0 ends the path.
  struct Scattering {
    render::Lobe lobe = render::Lobe::none;
    dvec3 wi{0};
    dvec3 weight{0};
    std::optional<double> pdf;
  };

  dvec3 radiance(const Ray& ray, SampleNumbers& numbers, Counters& counters, SampleOutputs outputs,
                 Rounding& rounding) const override;
  dvec3 tracePath(const Ray& cameraRay, SampleNumbers& numbers, Counters& counters, PathNotes& notes,
                  Rounding& rounding) const;
  /// Turns the shading normal of a surface whose material, or whose coat, has a normal map. If it has a coat, one layer
  /// is chosen, and `material` becomes this layer.
  void mapLayer(const dvec3& rayDirection, VertexNumbers u, Surface& surface, SurfaceMaterial& material,
                Rounding& rounding) const;
  /// Chooses the channel by which a direction is sampled; nothing if the surface does not disperse light.
  std::optional<ChannelChoice> channelAt(const Surface& surface, const dvec3& throughput, VertexNumbers u,
                                         Rounding& rounding) const;
  /// Returns the radiance of a ray that hits nothing, times its weight; `pdf` is that of the ray's direction. Camera
  /// rays see the backdrop.
  dvec3 background(const Ray& ray, std::optional<double> pdf, VertexNumbers u, Rounding& rounding) const;
  /// Returns a contribution to the path, which is darkened if light that was scattered `scatterings` times has a limit.
  dvec3 limited(const dvec3& contribution, std::uint32_t scatterings) const;
  /// Returns a sample of an entry of the light table as seen from a surface.
  std::optional<LightSample> sampleLight(std::uint32_t entry, const Surface& surface, VertexNumbers u) const;
  dvec3 emission(const SurfaceMaterial& material, const Ray& ray, double distance, const Surface& surface,
                 std::optional<double> pdf, PathNotes& notes, Rounding& rounding) const;
  dvec3 directLight(const Vertex& vertex, VertexNumbers u, const Volumes& volumes, Counters& counters, PathNotes& notes,
                    Rounding& rounding) const;
  Scattering scatter(const Vertex& vertex, VertexNumbers u, Rounding& rounding) const;
  /// Plays Russian roulette, and divides the throughput `beta` of a path that survives by the probability.
  bool survivesRoulette(dvec3& beta, VertexNumbers u, PathNotes& notes, Rounding& rounding) const;
  Scattering scatterSurface(const Vertex& vertex, VertexNumbers u, Rounding& rounding) const;
  Scattering scatterSmooth(const Vertex& vertex, render::Lobe lobe, VertexNumbers u, Rounding& rounding) const;

  render::RenderSettings settings_;
  Background background_;
  std::optional<EnvironmentMap> environment_;
  LightTable lights_;
};

}  // namespace candela::reference

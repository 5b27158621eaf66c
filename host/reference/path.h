// The estimator: docs/light-transport.md section 7.
#pragma once
#include <optional>

#include "host/reference/background.h"
#include "host/reference/bsdf.h"
#include "host/reference/lights.h"
#include "host/reference/path_notes.h"
#include "host/reference/pixel_tracer.h"
#include "host/reference/surface.h"
#include "host/render/settings.h"
#include "host/scene/scene.h"

namespace candela::reference {

class PathTracer final : public PixelTracer {
 public:
  /// The scene, which has a camera, must outlive the object.
  PathTracer(const scene::Scene& scene, const render::RenderSettings& settings);

  /// What sample() computes for the same place, with all that led to it.
  render::PathTrace trace(const render::PixelSample& place) const;

 private:
  /// The numbers of one path vertex, by the names of shaders/shared/dimensions.h.
  struct VertexNumbers;
  /// A surface with what its material's frame makes of it.
  struct Vertex;
  /// How a path goes on; `pdf` is none for a delta lobe. A weight of 0 ends it.
  struct Scattering {
    render::Lobe lobe = render::Lobe::none;
    dvec3 wi{0};
    dvec3 weight{0};
    std::optional<double> pdf;
  };

  dvec3 radiance(const Ray& ray, SampleNumbers& numbers, Counters& counters, render::PathRecord* record) const override;
  dvec3 walk(const Ray& cameraRay, SampleNumbers& numbers, Counters& counters, PathNotes& notes) const;
  /// The radiance that a ray without a hit finds, times its weight; `pdf` of the ray's direction.
  dvec3 background(const Ray& ray, std::optional<double> pdf) const;
  dvec3 emission(const Ray& ray, double distance, const Surface& surface, std::optional<double> pdf,
                 PathNotes& notes) const;
  dvec3 directLight(const Vertex& vertex, VertexNumbers u, Counters& counters, PathNotes& notes) const;
  Scattering scatter(const Vertex& vertex, VertexNumbers u) const;
  Scattering scatterSmooth(const Vertex& vertex, render::Lobe lobe, VertexNumbers u) const;

  render::RenderSettings settings_;
  Background background_;
  LightTable lights_;
};

}  // namespace candela::reference

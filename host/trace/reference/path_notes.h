// Notes about a path while it is traced: its decisions, or all that it computes, or nothing.
#pragma once
#include <optional>

#include "host/image/layers.h"
#include "host/trace/reference/lights.h"
#include "host/trace/reference/ray.h"
#include "host/trace/reference/sampler.h"
#include "host/trace/reference/surface.h"
#include "host/trace/reference/surface_material.h"
#include "host/trace/render/path_record.h"
#include "host/trace/render/path_trace.h"

namespace candela::reference {

/// A tracer calls these functions in the order of the path's computation. They do not affect it.
class PathNotes {
 public:
  /// Stores the decisions in `record`, and the layers in `layers`, unless they are null.
  PathNotes(render::PathRecord* record, image::LayerSample* layers) : record_(record), layers_(layers) {}
  /// Stores everything in `trace`.
  explicit PathNotes(render::PathTrace& trace) : trace_(&trace) {}

  /// The ray of `depth` starts; `pdf` as in VertexTrace, `radiance` of the path before it.
  void startVertex(std::uint32_t depth, const Ray& ray, std::optional<double> pdf, const dvec3& throughput,
                   const dvec3& radiance, SampleNumbers& numbers);
  void hit(double distance, const Surface& surface);
  /// The layers show this surface, whose normal map is applied. `distance` is the length of the path up to it.
  void firstHit(double distance, const Surface& surface, const SurfaceMaterial& material);
  /// `radiance` has all light of the path that was scattered `scatterings` times or less.
  void scattered(std::uint32_t scatterings, const dvec3& radiance);
  /// `radiance` is already multiplied by its weight.
  void emission(const dvec3& radiance, double weight);
  void lightChoice(const LightChoice& choice);
  /// `lightPdf` includes the probability of the choice.
  void shadowRay(const LightSample& light, double lightPdf, double bsdfPdf, bool occluded);
  void lit(double weight, const dvec3& radiance);
  void lobe(render::Lobe lobe);
  /// Only for directions by which the path continues.
  void scattering(const render::ScatteringTrace& next);
  void roulette(double probability, bool survived);
  /// The path has ended with this radiance.
  void finish(const dvec3& radiance);

 private:
  render::PathRecord* record_ = nullptr;
  image::LayerSample* layers_ = nullptr;
  render::PathTrace* trace_ = nullptr;
  render::VertexRecord* vertexRecord_ = nullptr;  ///< null: this vertex is not recorded
  render::VertexTrace* vertexTrace_ = nullptr;    ///< null: this vertex is not recorded
};

}  // namespace candela::reference

// What is noted of a path while it is traced: its decisions, or all that it computes, or nothing.
#pragma once
#include <optional>

#include "host/reference/lights.h"
#include "host/reference/ray.h"
#include "host/reference/sampler.h"
#include "host/reference/surface.h"
#include "host/render/path_record.h"
#include "host/render/path_trace.h"

namespace candela::reference {

/// A tracer calls these in the order in which a path comes to them; they change nothing for it.
class PathNotes {
 public:
  /// Decisions into `record`, unless it is null.
  explicit PathNotes(render::PathRecord* record) : record_(record) {}
  /// Everything into `trace`.
  explicit PathNotes(render::PathTrace& trace) : trace_(&trace) {}

  /// The ray of `depth` sets out; `pdf` as VertexTrace has it, `radiance` of the path before it.
  void startVertex(std::uint32_t depth, const Ray& ray, std::optional<double> pdf, const dvec3& throughput,
                   const dvec3& radiance, SampleNumbers& numbers);
  void hit(const Hit& hit, const Surface& surface);
  /// `radiance` times its weight.
  void emission(const dvec3& radiance, double weight);
  void lightChoice(const LightChoice& choice);
  /// `lightPdf` with the choice's probability.
  void shadowRay(const LightSample& light, double lightPdf, double bsdfPdf, bool occluded);
  void lit(double weight, const dvec3& radiance);
  void lobe(render::Lobe lobe);
  /// Only for directions with which the path goes on.
  void scattering(const render::ScatteringTrace& next);
  void roulette(double probability, bool survived);
  /// The path has ended with this radiance.
  void finish(const dvec3& radiance);

 private:
  render::PathRecord* record_ = nullptr;
  render::PathTrace* trace_ = nullptr;
  render::VertexRecord* vertexRecord_ = nullptr;  ///< null: this vertex is not kept
  render::VertexTrace* vertexTrace_ = nullptr;    ///< the same
};

}  // namespace candela::reference

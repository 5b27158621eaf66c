// Records the vertices of a path for comparison with the device.
#include "host/trace/reference/path_notes.h"

#include "shaders/shared/dimensions.h"

namespace candela::reference {

void PathNotes::startVertex(std::uint32_t depth, const Ray& ray, std::optional<double> pdf, const dvec3& throughput,
                            const dvec3& radiance, SampleNumbers& numbers) {
  vertexRecord_ = nullptr;
  if (record_ && record_->vertexCount < render::PathRecord::kRecordedVertices) {
    vertexRecord_ = &record_->vertices[record_->vertexCount++];
    *vertexRecord_ = {};
  }
  if (!trace_) return;
  if (vertexTrace_) vertexTrace_->radiance = radiance;
  vertexTrace_ = nullptr;
  trace_->vertexCount = depth;
  if (depth > render::PathTrace::kMaxVertices) return;
  vertexTrace_ = &trace_->vertices.emplace_back();
  vertexTrace_->origin = ray.origin;
  vertexTrace_->direction = ray.direction;
  vertexTrace_->pdf = pdf.value_or(0);
  vertexTrace_->throughput = throughput;
  const std::uint32_t block = kCameraDimensionCount + (depth - 1) * kVertexDimensionCount;
  for (std::uint32_t i = 0; i < vertexTrace_->numbers.size(); ++i) vertexTrace_->numbers[i] = numbers.word(block + i);
}

void PathNotes::hit(double distance, const Surface& surface) {
  if (vertexRecord_) vertexRecord_->primitive = surface.primitive;
  if (!vertexTrace_) return;
  vertexTrace_->hit = render::HitTrace{.primitive = surface.primitive,
                                       .material = surface.material,
                                       .distance = distance,
                                       .position = surface.position,
                                       .normal = surface.facingNormal,
                                       .shadingNormal = surface.shadingNormal,
                                       .fromOutside = surface.fromOutside};
}

void PathNotes::firstHit(double distance, const Surface& surface, const SurfaceMaterial& material) {
  if (!layers_) return;
  layers_->hit = image::LayerSample::FirstHit{.normal = surface.shadingNormal,
                                              .albedo = material.albedo(),
                                              .depth = distance,
                                              .position = surface.position,
                                              .texCoord = surface.attributes.texCoords[0],
                                              .primitive = surface.primitive};
}

void PathNotes::scattered(std::uint32_t scatterings, const dvec3& radiance) {
  if (!layers_) return;
  if (scatterings == 0) layers_->unscattered = radiance;
  if (scatterings == 1) layers_->scatteredOnce = radiance;
}

void PathNotes::emission(const dvec3& radiance, double weight) {
  if (vertexTrace_) vertexTrace_->emission = render::EmissionTrace{radiance, weight};
}

void PathNotes::lightChoice(const LightChoice& choice) {
  if (vertexTrace_) vertexTrace_->light = render::LightTrace{.entry = choice.entry, .primitive = choice.primitive};
}

void PathNotes::shadowRay(const LightSample& light, double lightPdf, double bsdfPdf, bool occluded) {
  const render::ShadowOutcome outcome = occluded ? render::ShadowOutcome::occluded : render::ShadowOutcome::visible;
  if (vertexRecord_) vertexRecord_->shadow = outcome;
  if (!vertexTrace_) return;
  render::LightTrace& trace = *vertexTrace_->light;
  trace.shadow = outcome;
  trace.direction = light.wi;
  trace.distance = light.distance;
  trace.pdf = lightPdf;
  trace.bsdfPdf = bsdfPdf;
}

void PathNotes::lit(double weight, const dvec3& radiance) {
  if (!vertexTrace_) return;
  vertexTrace_->light->weight = weight;
  vertexTrace_->light->radiance = radiance;
}

void PathNotes::lobe(render::Lobe lobe) {
  if (vertexRecord_) vertexRecord_->lobe = lobe;
}

void PathNotes::scattering(const render::ScatteringTrace& next) {
  if (vertexTrace_) vertexTrace_->scattering = next;
}

void PathNotes::roulette(double probability, bool survived) {
  if (vertexRecord_) vertexRecord_->survivedRoulette = survived;
  if (vertexTrace_) vertexTrace_->roulette = render::RouletteTrace{probability, survived};
}

void PathNotes::finish(const dvec3& radiance) {
  if (vertexTrace_) vertexTrace_->radiance = radiance;
  if (trace_) trace_->radiance = radiance;
}

}  // namespace candela::reference

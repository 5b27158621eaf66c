// Traces one camera ray per sample, and one more for ambient occlusion.
#include "host/trace/reference/views.h"

#include "host/trace/reference/material_choice.h"
#include "host/trace/reference/normal_map.h"
#include "host/trace/reference/sampling.h"
#include "shaders/shared/dimensions.h"

namespace candela::reference {
namespace {

double aoDistanceOf(const scene::Camera& camera, const std::optional<float>& asked) {
  if (asked) return *asked;
  return static_cast<float>(glm::length(dvec3(camera.at) - dvec3(camera.from)) / 4);
}

dvec3 indexColour(std::uint32_t primitive) {
  const Words words = pcg4d({primitive, 0, 0, 0});
  const auto channel = [](std::uint32_t word) { return ((word >> 24) + 1) / 256.0; };
  return {channel(words[0]), channel(words[1]), channel(words[2])};
}

// Returns the shading normal in the primitive's own orientation, whichever side is seen.
dvec3 ownShadingNormal(const Surface& surface) {
  return surface.fromOutside ? surface.shadingNormal : -surface.shadingNormal;
}

}  // namespace

ViewTracer::ViewTracer(const scene::Scene& scene, const render::RenderSettings& settings)
    : PixelTracer(scene, settings),
      view_(settings.image.integrator),
      askedAoDistance_(settings.image.aoDistance),
      aoDistance_(aoDistanceOf(*scene.camera, askedAoDistance_)) {}

void ViewTracer::setCamera(const scene::Camera& camera) {
  PixelTracer::setCamera(camera);
  aoDistance_ = aoDistanceOf(camera, askedAoDistance_);
}

dvec3 ViewTracer::radiance(const Ray& ray, SampleState& state) const {
  auto& [numbers, counters, outputs, arithmetic] = state;
  const std::uint64_t stepsBefore = counters.traversalSteps;
  Ray tested = ray;
  tested.opacityKey = opacityKeyOf(numbers, 1, false);
  const Hit hit = arithmetic.closest(tracing(), 1, tested, counters);
  const std::uint64_t steps = counters.traversalSteps - stepsBefore;
  if (hit) ++counters.vertices;

  render::VertexRecord vertex{.primitive = hit.primitive};
  dvec3 value(view_ == render::Integrator::ao ? 1 : 0);
  if (view_ == render::Integrator::cost) {
    value = dvec3(static_cast<double>(steps));
  } else if (hit) {
    Surface surface = arithmetic.surfaceAt(scene(), tested, hit);
    jitterTextures(surface, numbers, 1);
    chooseMaterial({scene(), arithmetic}, VertexNumbers(numbers, 1), surface);
    if (view_ == render::Integrator::normal) {
      applyNormalMap({scene(), arithmetic}, scene::TextureSlot::normal, ray.direction, surface);
    }
    value = valueAt(hit, surface, state, vertex);
  }
  if (outputs.record) *outputs.record = {.vertexCount = 1, .vertices = {vertex}};
  return value;
}

dvec3 ViewTracer::valueAt(const Hit& hit, const Surface& surface, SampleState& state,
                          render::VertexRecord& record) const {
  switch (view_) {
    case render::Integrator::normal:
      return (ownShadingNormal(surface) + 1.0) / 2.0;
    case render::Integrator::albedo:
      return materialAt(surface, state.arithmetic).albedo();
    case render::Integrator::depth:
      return dvec3(hit.distance);
    case render::Integrator::id:
      return indexColour(hit.primitive);
    default:
      return dvec3(isOpen(surface, state, record) ? 1 : 0);
  }
}

bool ViewTracer::isOpen(const Surface& surface, SampleState& state, render::VertexRecord& record) const {
  auto& [numbers, counters, outputs, arithmetic] = state;
  constexpr std::uint32_t kFirstVertex = kCameraDimensionCount;
  const dvec2 u(numbers.unit(kFirstVertex + kDimensionBsdfU), numbers.unit(kFirstVertex + kDimensionBsdfV));
  const dvec3 local = arithmetic.sampledDirection(sampleCosineHemisphere(u));
  const dvec3 wi = arithmetic.direction(Frame(surface.shadingNormal).toWorld(local));
  const bool above = dot(wi, surface.facingNormal) > 0;
  arithmetic.decide(above);
  if (!above) return false;

  ++counters.shadowRays;
  const Ray ray{surface.position, wi, surface.primitive, surface.outwardNormal, opacityKeyOf(numbers, 1, true)};
  const bool blocked = arithmetic.isOccluded(tracing(), ray, {.distance = aoDistance_}, counters);
  arithmetic.decide(blocked);
  record.shadow = blocked ? render::ShadowOutcome::occluded : render::ShadowOutcome::visible;
  return !blocked;
}

}  // namespace candela::reference

// Traces the samples of one pixel.
#include "host/reference/pixel_tracer.h"

namespace candela::reference {

PixelTracer::PixelTracer(const scene::Scene& scene, const render::RenderSettings& settings)
    : scene_(scene),
      sampler_(settings.sampler, settings.seed, settings.sampleCount),
      camera_(*scene.camera, settings),
      tracing_(scene, settings) {}

dvec3 PixelTracer::sample(std::uint32_t x, std::uint32_t y, std::uint32_t sampleIndex, Counters& counters,
                          render::PathRecord* record) const {
  SampleNumbers numbers = numbersOf(x, y, sampleIndex);
  const Ray ray = cameraRay(x, y, numbers);
  ++counters.samples;
  ++counters.cameraRays;
  return radiance(ray, numbers, counters, record);
}

}  // namespace candela::reference

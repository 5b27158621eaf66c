// Traces the samples of one pixel.
#include "host/reference/pixel_tracer.h"

namespace candela::reference {

PixelTracer::PixelTracer(const scene::Scene& scene, const render::RenderSettings& settings)
    : scene_(scene),
      image_(settings.image),
      sampler_(image_.sampler, image_.seed, image_.sampleCount),
      camera_(*scene.camera, image_),
      tracing_(scene, settings),
      materials_(scene.materials.begin(), scene.materials.end()) {}

void PixelTracer::setSeed(std::uint32_t seed) {
  image_.seed = seed;
  sampler_ = Sampler(image_.sampler, image_.seed, image_.sampleCount);
}

void PixelTracer::setCamera(const scene::Camera& camera) { camera_ = CameraRays(camera, image_); }

dvec3 PixelTracer::sample(std::uint32_t x, std::uint32_t y, std::uint32_t sampleIndex, Counters& counters,
                          render::PathRecord* record) const {
  SampleNumbers numbers = numbersOf(x, y, sampleIndex);
  const Ray ray = cameraRay(x, y, numbers);
  ++counters.samples;
  ++counters.cameraRays;
  return radiance(ray, numbers, counters, record);
}

}  // namespace candela::reference

// Traces the samples of one pixel.
#include "host/trace/reference/pixel_tracer.h"

#include <algorithm>

#include "host/trace/reference/opacity.h"
#include "shaders/shared/dimensions.h"

namespace candela::reference {
namespace {

bool variesOverTriangles(const scene::Scene& scene) {
  return std::ranges::any_of(scene.materials, scene::isTextured) ||
         std::ranges::any_of(scene.meshes, [](const scene::Mesh& mesh) { return !mesh.colours.empty(); });
}

// Returns whether camera rays start at different points, which a device computes.
bool originVaries(const scene::Camera& camera) { return camera.aperture > 0 || camera.orthographicHeight; }

}  // namespace

PixelTracer::PixelTracer(const scene::Scene& scene, const render::RenderSettings& settings)
    : scene_(scene),
      image_(settings.image),
      sampler_(image_.sampler, image_.seed, image_.sampleCount),
      camera_(*scene.camera, image_),
      originVaries_(originVaries(*scene.camera)),
      variesOverTriangles_(variesOverTriangles(scene)),
      isTransparent_(std::ranges::any_of(scene.materials, [](const auto& m) { return m.opacity.has_value(); })),
      tracing_(scene, settings),
      materials_(scene.materials.begin(), scene.materials.end()) {}

void PixelTracer::jitterTextures(Surface& surface, SampleNumbers& numbers, std::uint32_t vertex) const {
  if (!variesOverTriangles_) return;
  const std::uint32_t block = kCameraDimensionCount + (vertex - 1) * kVertexDimensionCount;
  surface.textureJitter = {numbers.unit(block + kDimensionTextureU), numbers.unit(block + kDimensionTextureV)};
  surface.lightTextureJitter = {numbers.unit(block + kDimensionLightTextureU),
                                numbers.unit(block + kDimensionLightTextureV)};
}

std::uint32_t PixelTracer::opacityKeyOf(const SampleNumbers& numbers, std::uint32_t vertex, bool isShadowRay) const {
  if (!isTransparent_) return 0;
  return opacityKey(numbers.pixel(), numbers.sample(), image_.seed, vertex, isShadowRay);
}

void PixelTracer::setSampling(std::uint32_t seed, std::uint32_t sampleCount) {
  image_.seed = seed;
  image_.sampleCount = sampleCount;
  sampler_ = Sampler(image_.sampler, image_.seed, image_.sampleCount);
  camera_.setJitter(image_.jittersPixels());
}

void PixelTracer::setCamera(const scene::Camera& camera) {
  camera_ = CameraRays(camera, image_);
  originVaries_ = originVaries(camera);
  tracing_.setEye(camera.from);
}

dvec3 PixelTracer::sample(std::uint32_t x, std::uint32_t y, std::uint32_t sampleIndex, Counters& counters,
                          SampleOutputs outputs) const {
  Arithmetic exact;
  return sample({x, y, sampleIndex}, counters, outputs, exact, nullptr);
}

dvec3 PixelTracer::sample(const render::PixelSample& sample, Counters& counters, SampleOutputs outputs,
                          Arithmetic& arithmetic, NumberCache* cache) const {
  SampleNumbers numbers = numbersOf(sample, cache);
  const Ray ray = cameraRay(sample, numbers, arithmetic);
  ++counters.samples;
  ++counters.cameraRays;
  SampleState state{numbers, counters, outputs, arithmetic};
  return arithmetic.radiance(radiance(ray, state));
}

}  // namespace candela::reference

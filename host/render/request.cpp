// Completes a request by the scene's settings and the defaults.
#include "host/render/request.h"

namespace candela::render {
namespace {

AccelKind accelOf(const scene::Scene& scene) {
  constexpr std::uint32_t kNone = 0;
  constexpr std::uint32_t kGrid = 1;
  if (scene.requestedAccel == kNone) return AccelKind::none;
  if (scene.requestedAccel == kGrid) return AccelKind::grid;
  return AccelKind::bvh;
}

}  // namespace

std::uint32_t requestedSampleCount(const RenderRequest& request, const scene::Scene& scene) {
  return request.sampleCount.value_or(scene.requestedSamples.value_or(ImageSettings{}.sampleCount));
}

RenderSettings resolve(const RenderRequest& request, const scene::Scene& scene) {
  RenderSettings settings = request.settings;
  const std::uint32_t samples = requestedSampleCount(request, scene);
  settings.image.antialiasing = samples > 0;
  settings.image.sampleCount = samples > 0 ? samples : 1;
  settings.image.size = request.size.value_or(Extent{scene.camera->width, scene.camera->height});
  settings.image.maxDepth = request.maxDepth.value_or(defaultMaxDepth(settings.image.integrator));
  settings.structure.accel = request.accel.value_or(accelOf(scene));
  settings.structure.accelIsPreference = !request.accel;
  return settings;
}

}  // namespace candela::render

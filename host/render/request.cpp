// Completes a request by the scene's settings and the defaults.
#include "host/render/request.h"

#include <algorithm>

#include "host/core/errors.h"
#include "host/scene/film_scale.h"

namespace candela::render {
namespace {

AccelKind accelOf(const scene::Scene& scene) {
  if (scene.requestedAccel == scene::RequestedAccel::none) return AccelKind::none;
  if (scene.requestedAccel == scene::RequestedAccel::grid) return AccelKind::grid;
  return AccelKind::bvh;
}

}  // namespace

RenderSettings::RenderSettings(const RenderRequest& request)
    : image(request.image), structure(request.structure), execution(request.execution) {}

std::uint32_t requestedSampleCount(const RenderRequest& request, const scene::Scene& scene) {
  return request.sampleCount.value_or(scene.requestedSamples.value_or(ImageSettings{}.sampleCount));
}

RenderSettings resolve(const RenderRequest& request, const scene::Scene& scene) {
  RenderSettings settings(request);
  const std::uint32_t samples = requestedSampleCount(request, scene);
  settings.image.antialiasing = samples > 0;
  settings.image.sampleCount = samples > 0 ? samples : 1;
  settings.image.size = request.size.value_or(Extent{scene.camera->width, scene.camera->height});
  settings.image.maxDepth = request.maxDepth.value_or(defaultMaxDepth(settings.image.integrator));
  const bool isView = render::isView(settings.image.integrator);
  settings.image.filmScale = request.filmScale ? *request.filmScale : isView ? 0 : filmScaleOf(scene);
  settings.structure.accel = request.accel.value_or(accelOf(scene));
  settings.structure.accelIsPreference = !request.accel;
  return settings;
}

void requireIntegrator(const scene::Scene& scene, const RenderSettings& settings) {
  if (settings.image.backdrop != Backdrop::environment && settings.image.integrator != Integrator::path) {
    throw UsageError("--background colour and none apply only to the path tracer; use --integrator path");
  }
  if (!settings.image.layers.isEmpty() && settings.image.integrator != Integrator::path) {
    throw UsageError("--aov applies only to the path tracer; use --integrator path");
  }
  if (settings.image.integrator != Integrator::whitted) return;
  if (scene.environment) {
    throw UsageError(
        "--integrator whitted: Whitted ray tracing does not support environments (--env); use --integrator path");
  }
  const auto lacksCoefficients = [](const scene::Material& material) { return !material.whitted; };
  if (std::ranges::any_of(scene.materials, lacksCoefficients)) {
    throw UsageError("--integrator whitted: " + scene.name +
                     ": the materials have no coefficients for Whitted ray tracing, which only NFF and P3F state; use "
                     "--integrator path");
  }
  if (!scene.punctualLights.empty()) {
    throw UsageError("--integrator whitted: " + scene.name +
                     ": the scene has lights with fall-off, spot lights or directional lights, which Whitted ray "
                     "tracing does not support; use --integrator path");
  }
}

}  // namespace candela::render

// Completes a request by the scene's settings and the defaults.
#include "host/trace/render/request.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/base/errors.h"
#include "host/base/setting_words.h"
#include "host/scene/film_scale.h"
#include "host/trace/render/light_selection.h"
#include "host/trace/render/setting_names.h"

namespace candela::render {
namespace {

AccelKind accelOf(const scene::Scene& scene) {
  if (scene.requestedAccel == scene::RequestedAccel::none) return AccelKind::none;
  if (scene.requestedAccel == scene::RequestedAccel::grid) return AccelKind::grid;
  return AccelKind::bvh;
}

Extent sizeOf(const scene::Camera& camera) { return {camera.width, camera.height}; }

std::uint32_t maxDepthOf(const scene::Scene& scene, Integrator integrator) {
  const std::uint32_t absent = defaultMaxDepth(integrator);
  return integrator == Integrator::path ? scene.requestedMaxDepth.value_or(absent) : absent;
}

}  // namespace

RenderSettings::RenderSettings(const RenderRequest& request)
    : image{request.image}, structure{request.structure}, execution(request.execution) {}

RenderSettings resolve(const RenderRequest& request, const scene::Scene& scene) {
  RenderSettings settings(request);
  const std::uint32_t samples = request.sampleCount.value_or(
      scene.requestedSamples.value_or(ImageSettings{}.sampleCount));
  settings.image.antialiasing = samples > 0;
  settings.image.sampleCount = samples > 0 ? samples : 1;
  settings.image.size = request.size.value_or(sizeOf(*scene.camera));
  settings.image.crop = request.crop || request.size ? request.crop : scene.requestedCrop;
  settings.image.maxDepth = request.maxDepth.value_or(maxDepthOf(scene, settings.image.integrator));
  settings.image.filter = request.filter.value_or(scene.requestedFilter.value_or(PixelFilter()));
  const bool isView = render::isView(settings.image.integrator);
  settings.image.filmScale = request.filmScale ? *request.filmScale : isView ? 0 : filmScaleOf(scene);
  const bool hasLights = settings.image.integrator == Integrator::path;
  settings.image.lights = request.lights.value_or(hasLights ? selectionFor(scene) : LightSelection::power);
  settings.structure.accel = request.accel.value_or(accelOf(scene));
  settings.structure.accelIsPreference = !request.accel;
  return settings;
}

RenderRequest withoutSceneCrop(RenderRequest request, const scene::Scene& scene) {
  if (!request.size) request.size = sizeOf(*scene.camera);
  return request;
}

RenderRequest requestOf(const RenderSettings& settings) {
  const ImageSettings& image = settings.image;
  return {.sampleCount = image.antialiasing ? image.sampleCount : 0,
          .size = image.size,
          .crop = image.crop,
          .accel = settings.structure.accel,
          .maxDepth = image.maxDepth,
          .filter = image.filter,
          .filmScale = image.filmScale,
          .lights = image.lights,
          .image = image,
          .structure = settings.structure,
          .execution = settings.execution};
}

void requireIntegrator(const scene::Scene& scene, const RenderSettings& settings) {
  const Integrator integrator = settings.image.integrator;
  const auto refuse = [](const std::string& reason) {
    throw UsageError(fmt::format("{}; use {}", reason, settingWords("integrator", nameOf(Integrator::path))));
  };
  if (settings.image.backdrop != Backdrop::environment && integrator != Integrator::path) {
    refuse(
        fmt::format("{} applies only to the path tracer", settingWords("background", nameOf(settings.image.backdrop))));
  }
  if (!settings.image.layers.isEmpty() && integrator != Integrator::path) {
    refuse("only the path tracer has layers");
  }
  if (integrator != Integrator::whitted) return;
  if (scene.environment) refuse("Whitted ray tracing does not support environments");
  const auto lacksCoefficients = [](const scene::Material& material) { return !material.whitted; };
  if (std::ranges::any_of(scene.materials, lacksCoefficients)) {
    refuse(scene.name + ": the materials have no coefficients for Whitted ray tracing, which only NFF and P3F state");
  }
  if (!scene.punctualLights.empty()) {
    refuse(
        scene.name +
        ": the scene has lights with fall-off, spot lights or directional lights, which Whitted ray tracing does not "
        "support");
  }
}

}  // namespace candela::render

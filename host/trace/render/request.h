// A request for a render, which the scene's own settings and the defaults complete.
#pragma once
#include <cstdint>
#include <optional>

#include "host/scene/scene.h"
#include "host/trace/render/settings.h"

namespace candela::render {

/// A request; absent members are taken from the scene, else from the defaults.
struct RenderRequest {
  /// Samples per pixel; 0: one sample through the pixel's origin, without antialiasing. Default: 16.
  std::optional<std::uint32_t> sampleCount;
  std::optional<Extent> size;      ///< default: the resolution of the scene's camera
  std::optional<Window> crop;      ///< default: that of the scene if `size` is absent, too, else the image
  std::optional<AccelKind> accel;  ///< default: BVH
  /// Default: that of the scene for the path tracer, else defaultMaxDepth().
  std::optional<std::uint32_t> maxDepth;
  std::optional<PixelFilter> filter;       ///< default: box
  std::optional<std::uint32_t> filmScale;  ///< default: scene::filmScaleOf(), and 0 for views
  std::optional<LightSelection> lights;    ///< default: selectionFor(), and power for other integrators than path
  ImageChoices image;
  StructureChoices structure;
  ExecutionSettings execution;
};

/// Returns the settings of a render of `scene`, which must have a camera. An acceleration structure that only the scene
/// requests is a preference: see StructureSettings::accelIsPreference.
RenderSettings resolve(const RenderRequest& request, const scene::Scene& scene);

/// Returns the request without the crop of the scene: that of the whole image unless it states a crop itself.
RenderRequest withoutSceneCrop(RenderRequest request, const scene::Scene& scene);

/// Returns the request that has these settings with any scene.
RenderRequest requestOf(const RenderSettings& settings);

/// Throws UsageError if the settings select the Whitted tracer, and the scene has lights or materials that it does not
/// have: point lights with fall-off, spot and directional lights, materials without Whitted coefficients; and if they
/// select a Backdrop that the integrator does not have. Every session requires this.
void requireIntegrator(const scene::Scene& scene, const RenderSettings& settings);

}  // namespace candela::render

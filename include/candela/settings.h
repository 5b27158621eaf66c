// The settings of a render: what a caller requests, and what results with the scene's own requests and the defaults.
//
//   candela::RenderRequest request;
//   request.sampleCount = 256;
//   request.size = candela::Extent{1280, 720};
//   request.image.seed = 7;
//   const candela::RenderSettings settings = candela::resolve(request, scene);
//
// Only resolve() makes settings, so that no program ignores the size, the samples or the structure that a scene
// requests.
#pragma once
#include "host/trace/render/request.h"
#include "host/trace/render/settings.h"

namespace candela {

/// Width and height in pixels, each in [1, 65535].
using render::Extent;
/// A rectangle of pixels; (0, 0) is the top left of the image.
using render::Window;

/// Samples per pixel, size, crop, depth, filter, structure and scale of the film, each of which the scene may state,
/// and the choices of image, structure and execution, which it cannot.
using render::RenderRequest;
/// Three parts: `image` determines every bit of the film, `structure` and `execution` change none.
using render::RenderSettings;
/// Throws UsageError if the scene has no camera, or the tracers cannot render it so.
using render::resolve;

using render::AccelKind;
using render::Backdrop;
using render::BuildQuality;
using render::BvhLayout;
using render::BvhSplit;
using render::FilterKind;
using render::Integrator;
using render::KernelKind;
using render::LensKind;
using render::PixelFilter;
using render::PixelOrigin;
using render::SamplerKind;
using render::SceneLoads;

using render::kMaxSampleCount;  ///< per pixel

}  // namespace candela

// Denoises the image of a film by the tracer's device, for `candela denoise` and `candela render --denoise`.
#pragma once
#include "host/app/cli/command_arguments.h"
#include "host/base/log.h"
#include "host/image/image.h"

namespace candela::cli {

/// Throws NoDeviceError if Open Image Denoise is requested and missing, and UsageError if --denoise is given for a
/// render whose film has no statistics of light: before the scene is read, by its integrator, and afterwards, by its
/// number of samples.
void requireDenoisable(const RenderArguments& arguments);
void requireDenoisable(const RenderArguments& arguments, const render::ImageSettings& image);

/// Returns `arguments` with the layers that --denoise needs.
RenderArguments withDenoiseLayers(RenderArguments arguments);

/// Denoises the image of a film: by Open Image Denoise if it is requested; by the reference with --device cpu, else by
/// a Vulkan device; if that is lost or runs out of memory, by the reference, with a warning. Throws UsageError if the
/// film lacks statistics, and NoDeviceError.
void denoiseImage(image::Image& image, const image::Film& film, const DenoiseArguments& arguments, const Log& log);

/// Denoises the image of a render as denoiseImage() does, but by the reference also if no device can be opened. The
/// image of a render that was interrupted before any pixel had two samples stays as it is, with a warning.
void denoiseResult(image::Image& image, const image::Film& film, bool isInterrupted, const RenderArguments& arguments,
                   const Log& log);

}  // namespace candela::cli

// Open Image Denoise, a library that is loaded when it is needed. Nothing is linked with it.
#pragma once
#include "host/image/film.h"
#include "host/image/image.h"

namespace candela::denoise {

/// Throws NoDeviceError, with the remedy, if libOpenImageDenoise.so.2 cannot be loaded.
void requireOidn();

/// Replaces the colours of the image of a film by the result of the library's filter `RT` on its CPU device, guided by
/// the mean albedo and the mean normal of each pixel. The metadata and the variances change as those of denoise() do.
/// Throws as requireStatistics() and requireOidn() do, and NoDeviceError with the library's message if it fails.
void denoiseByOidn(image::Image& image, const image::Film& film);

}  // namespace candela::denoise

// Denoises the image of a film: docs/denoising.md.
#pragma once
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "host/image/image.h"
#include "host/trace/denoise/isolated_samples.h"
#include "host/trace/denoise/pixel_statistics.h"

namespace candela::denoise {

/// filterByReference(), or filterOnDevice() of a device.
using Filter = std::function<std::vector<glm::vec3>(const PixelStatistics&)>;

/// Name of the metadata entry of a denoised image.
inline constexpr const char* kDenoisedMetadata = "candela.denoised";

/// Replaces the colours of the image of a film. The image loses its variances, which are not those of the new colours,
/// and gains the metadata entry kDenoisedMetadata. Returns the light of isolated samples that was taken away. Throws as
/// requireStatistics() does.
LimitedLight denoise(image::Image& image, const image::Film& film, const Filter& filter);

}  // namespace candela::denoise

// The filter of docs/denoising.md in double precision, with which devices are compared.
#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "host/trace/denoise/pixel_statistics.h"

namespace candela::denoise {

/// Returns the filtered light of each pixel, divided by the reflectance as gpu::DenoisePixel::light is. A pixel that is
/// not filtered has its own light.
std::vector<glm::vec3> filterByReference(const PixelStatistics& statistics);

}  // namespace candela::denoise

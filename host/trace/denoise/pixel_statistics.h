// The statistics of a film's pixels that the denoiser reads.
#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "host/image/film.h"
#include "shaders/shared/denoise_data.h"

namespace candela::denoise {

/// The statistics of a film, row by row from the top.
struct PixelStatistics {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<gpu::DenoisePixel> pixels;
};

/// Throws UsageError, with the remedy, if the film lacks the sums that statisticsOf() reads (image::Layer::moments), or
/// if no pixel has two samples.
void requireStatistics(const image::Film& film);

/// Computes docs/denoising.md, section 2, in double precision, and rounds the results to single precision. A
/// pixel with fewer than two samples has the count 0. The film must pass requireStatistics().
PixelStatistics statisticsOf(const image::Film& film);

/// Returns the divisor of the light of a pixel with this gpu::DenoisePixel::reflectance: at least 0.01 per channel.
glm::vec3 divisorOf(const glm::vec4& reflectance);

}  // namespace candela::denoise

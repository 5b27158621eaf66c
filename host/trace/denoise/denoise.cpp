// Limits isolated samples, filters the light, and multiplies it by the reflectance.
#include "host/trace/denoise/denoise.h"

namespace candela::denoise {

LimitedLight denoise(image::Image& image, const image::Film& film, const Filter& filter) {
  requireStatistics(film);
  PixelStatistics statistics = statisticsOf(film);
  const LimitedLight limited = limitIsolatedSamples(statistics);
  const std::vector<glm::vec3> light = filter(statistics);
  for (std::size_t i = 0; i < light.size(); ++i) {
    const gpu::DenoisePixel& pixel = statistics.pixels[i];
    if (pixel.light.w > 0) image.rgb[i] = light[i] * divisorOf(pixel.reflectance);
  }
  image.luminanceVariance.clear();
  image.metadata[kDenoisedMetadata] = "by statistics of pixels: neighbours with similar samples, normals and albedos";
  return limited;
}

}  // namespace candela::denoise

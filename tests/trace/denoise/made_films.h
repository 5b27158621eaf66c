// Films with the sums that denoising needs, made of random samples.
#pragma once
#include <functional>
#include <random>

#include "host/trace/denoise/pixel_statistics.h"

namespace candela::denoise {

inline image::LayerSet momentLayers() {
  image::LayerSet layers;
  layers.add(image::Layer::moments);
  return layers;
}

/// The properties that the samples of a pixel share.
struct MadePixel {
  glm::dvec3 radiance{1};  ///< mean of the samples
  glm::dvec3 albedo{0.5};
  glm::dvec3 normal{0, 0, 1};
  double noise = 1;  ///< 0: equal samples; 1: exponentially distributed ones
  bool isHit = true;
};

using PixelMaker = std::function<MadePixel(std::uint32_t x, std::uint32_t y)>;

inline void addMadeSamples(image::Film& film, std::uint32_t x, std::uint32_t y, const MadePixel& pixel,
                           std::uint32_t count) {
  std::mt19937 random(1 + x + 1000 * y);
  std::exponential_distribution<double> exponential;
  for (std::uint32_t i = 0; i < count; ++i) {
    const glm::dvec3 radiance = pixel.radiance * (1 - pixel.noise + pixel.noise * exponential(random));
    image::LayerSample sample;
    if (pixel.isHit) sample.hit = image::LayerSample::FirstHit{.normal = pixel.normal, .albedo = pixel.albedo};
    film.addSample(x, y, radiance, i);
    film.addLayers(x, y, sample, radiance);
  }
}

inline image::Film madeFilm(std::uint32_t width, std::uint32_t height, std::uint32_t count, const PixelMaker& pixelAt) {
  image::Film film(width, height, momentLayers());
  for (std::uint32_t y = 0; y < height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) addMadeSamples(film, x, y, pixelAt(x, y), count);
  }
  return film;
}

}  // namespace candela::denoise

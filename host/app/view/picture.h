// The picture of one tracer, as it is shown: the latest value of each pixel, at whatever resolution it was rendered.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "host/image/film.h"
#include "host/image/mattes.h"
#include "host/trace/render/extent.h"

namespace candela::view {

/// Means of pixels, or values of a layer, row by row from the top: red, green, blue, and the number of samples. 0
/// samples: no value yet; -N: one sample of a picture whose sides are divided by N.
struct Picture {
  render::Extent size;
  std::vector<glm::vec4> pixels;
  std::vector<image::IdCounts> ids{};  ///< of each pixel, if the picture shows mattes
  bool isLight = true;                 ///< false: the values are those of a layer that is not a part of the light

  explicit Picture(const render::Extent& extent)
      : size(extent), pixels(std::size_t{extent.width} * extent.height, glm::vec4(0)) {}
  const glm::vec4& at(std::uint32_t x, std::uint32_t y) const { return pixels[std::size_t{y} * size.width + x]; }
};

/// Replaces each pixel by the mean of the film's pixel at the same position, if that has samples. A pixel of a film
/// of lower resolution covers several pixels of the picture. shaders/film_means.comp does the same.
void show(const image::Film& film, Picture& picture);

/// Calls `use(pixel, x, y, samples)` for each pixel of the picture, whose index is `pixel`, with the film's pixel at
/// the same position and the last component of Picture::pixels, if that pixel of the film has samples.
template <class Use>
void forEachShown(const image::Film& film, const Picture& picture, Use use) {
  const std::uint32_t scale = (picture.size.width + film.width() - 1) / film.width();
  for (std::uint32_t y = 0; y < picture.size.height; ++y) {
    const auto filmY = static_cast<std::uint32_t>(std::uint64_t{y} * film.height() / picture.size.height);
    for (std::uint32_t x = 0; x < picture.size.width; ++x) {
      const auto filmX = static_cast<std::uint32_t>(std::uint64_t{x} * film.width() / picture.size.width);
      const std::uint32_t samples = film.at(filmX, filmY).sampleCount;
      if (samples == 0) continue;
      use(std::size_t{y} * picture.size.width + x, filmX, filmY,
          scale == 1 ? static_cast<float>(samples) : -static_cast<float>(scale));
    }
  }
}

/// Comparison of two pictures of one size, of the pixels that have the same number of samples in both.
struct PictureDifference {
  std::uint64_t pixels = 0;   ///< compared
  std::uint64_t unequal = 0;  ///< whose values differ by more than kEqual of the larger one
  double meanA = 0;           ///< luminance; 0 for pictures of values that are not light
  double meanB = 0;
  glm::uvec2 worst{0};         ///< pixel with the maximum difference
  double worstDifference = 0;  ///< A - B, of its luminance or, without light, of the channel that differs most

  static constexpr double kEqual = 1e-4;
};
PictureDifference compare(const Picture& a, const Picture& b);

}  // namespace candela::view

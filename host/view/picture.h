// The picture of one tracer, as it is shown: the latest value of each pixel, at whatever resolution it was rendered.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "host/image/film.h"
#include "host/render/extent.h"

namespace candela::view {

/// Means of pixels, row by row from the top: red, green, blue, and the number of samples. 0 samples: no value yet; -N:
/// one sample of a picture whose sides are divided by N.
struct Picture {
  render::Extent size;
  std::vector<glm::vec4> pixels;

  explicit Picture(const render::Extent& extent)
      : size(extent), pixels(std::size_t{extent.width} * extent.height, glm::vec4(0)) {}
  const glm::vec4& at(std::uint32_t x, std::uint32_t y) const { return pixels[std::size_t{y} * size.width + x]; }
};

/// Replaces each pixel by the mean of the film's pixel at the same position, if that has samples. A pixel of a film
/// of lower resolution covers several pixels of the picture. shaders/film_means.comp does the same.
void show(const image::Film& film, Picture& picture);

/// Comparison of two pictures of one size, of the pixels that have the same number of samples in both.
struct PictureDifference {
  std::uint64_t pixels = 0;   ///< compared
  std::uint64_t unequal = 0;  ///< whose values differ by more than kEqual of the larger one
  double meanA = 0;           ///< luminance
  double meanB = 0;
  glm::uvec2 worst{0};         ///< pixel with the maximum difference
  double worstDifference = 0;  ///< of its luminance, A - B

  static constexpr double kEqual = 1e-4;
};
PictureDifference compare(const Picture& a, const Picture& b);

}  // namespace candela::view

// Means of films, and their comparison.
#include "host/view/picture.h"

#include <algorithm>
#include <cmath>

namespace candela::view {
namespace {

double luminanceOf(const glm::vec4& pixel) { return 0.2126 * pixel.x + 0.7152 * pixel.y + 0.0722 * pixel.z; }

bool isEqual(const glm::vec4& a, const glm::vec4& b) {
  for (int i = 0; i < 3; ++i) {
    if (std::abs(double{a[i]} - b[i]) > PictureDifference::kEqual * std::max(std::abs(a[i]), std::abs(b[i])))
      return false;
  }
  return true;
}

}  // namespace

void show(const image::Film& film, Picture& picture) {
  const std::uint32_t scale = (picture.size.width + film.width() - 1) / film.width();
  for (std::uint32_t y = 0; y < picture.size.height; ++y) {
    const std::uint32_t filmY = static_cast<std::uint32_t>(std::uint64_t{y} * film.height() / picture.size.height);
    for (std::uint32_t x = 0; x < picture.size.width; ++x) {
      const std::uint32_t filmX = static_cast<std::uint32_t>(std::uint64_t{x} * film.width() / picture.size.width);
      const std::uint32_t samples = film.at(filmX, filmY).sampleCount;
      if (samples == 0) continue;
      picture.pixels[std::size_t{y} * picture.size.width + x] = glm::vec4(glm::vec3(film.mean(filmX, filmY)),
                                                                          scale == 1 ? 1.0 * samples : -1.0 * scale);
    }
  }
}

PictureDifference compare(const Picture& a, const Picture& b) {
  PictureDifference result;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const glm::vec4& left = a.pixels[i];
    const glm::vec4& right = b.pixels[i];
    if (left.w <= 0 || left.w != right.w) continue;
    ++result.pixels;
    result.meanA += luminanceOf(left);
    result.meanB += luminanceOf(right);
    if (!isEqual(left, right)) ++result.unequal;
    const double difference = luminanceOf(left) - luminanceOf(right);
    if (std::abs(difference) <= std::abs(result.worstDifference)) continue;
    result.worstDifference = difference;
    result.worst = {i % a.size.width, i / a.size.width};
  }
  const double count = static_cast<double>(std::max<std::uint64_t>(result.pixels, 1));
  result.meanA /= count;
  result.meanB /= count;
  return result;
}

}  // namespace candela::view

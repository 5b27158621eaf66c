// Means of films, and their comparison.
#include "host/app/view/picture.h"

#include <algorithm>
#include <cmath>

namespace candela::view {
namespace {

double luminanceOf(const glm::vec4& pixel) { return 0.2126 * pixel.x + 0.7152 * pixel.y + 0.0722 * pixel.z; }

float maxMagnitude(const glm::vec4& pixel) {
  return std::max({std::abs(pixel.x), std::abs(pixel.y), std::abs(pixel.z)});
}

// A channel of a vector may be close to 0, so that it is compared with the longest channel.
bool isEqual(const glm::vec4& a, const glm::vec4& b, bool isLight) {
  const float longest = std::max(maxMagnitude(a), maxMagnitude(b));
  for (int i = 0; i < 3; ++i) {
    const float magnitude = isLight ? std::max(std::abs(a[i]), std::abs(b[i])) : longest;
    if (std::abs(double{a[i]} - b[i]) > PictureDifference::kEqual * magnitude) return false;
  }
  return true;
}

double differenceOf(const glm::vec4& a, const glm::vec4& b, bool isLight) {
  if (isLight) return luminanceOf(a) - luminanceOf(b);
  double most = 0;
  for (int i = 0; i < 3; ++i) {
    const double difference = double{a[i]} - b[i];
    if (std::abs(difference) > std::abs(most)) most = difference;
  }
  return most;
}

}  // namespace

void show(const image::Film& film, Picture& picture) {
  forEachShown(film, picture, [&](std::size_t pixel, std::uint32_t x, std::uint32_t y, float samples) {
    picture.pixels[pixel] = glm::vec4(glm::vec3(film.mean(x, y)), samples);
  });
}

PictureDifference compare(const Picture& a, const Picture& b) {
  PictureDifference result;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const glm::vec4& left = a.pixels[i];
    const glm::vec4& right = b.pixels[i];
    if (left.w <= 0 || left.w != right.w) continue;
    ++result.pixels;
    if (a.isLight) {
      result.meanA += luminanceOf(left);
      result.meanB += luminanceOf(right);
    }
    if (!isEqual(left, right, a.isLight)) ++result.unequal;
    const double difference = differenceOf(left, right, a.isLight);
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

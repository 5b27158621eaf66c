// Averages blocks of pixels.
#include "host/judge/report/reduce.h"

#include <algorithm>

#include "host/base/divide_up.h"

namespace candela::report {
namespace {

glm::vec3 blockMean(const image::Image& image, std::uint32_t left, std::uint32_t top, std::uint32_t k) {
  const std::uint32_t right = std::min(left + k, image.width);
  const std::uint32_t bottom = std::min(top + k, image.height);
  glm::dvec3 sum(0);
  for (std::uint32_t y = top; y < bottom; ++y) {
    for (std::uint32_t x = left; x < right; ++x) sum += glm::dvec3(image.at(x, y));
  }
  return glm::vec3(sum / (double{1} * (right - left) * (bottom - top)));
}

}  // namespace

std::uint32_t reductionOf(std::uint32_t width, std::uint32_t height) {
  std::uint32_t k = 1;
  while (std::uint64_t{divideUp(width, k)} * divideUp(height, k) > kMaxPixels) ++k;
  return k;
}

image::Image reduced(const image::Image& image, std::uint32_t k) {
  image::Image small;
  small.width = divideUp(image.width, k);
  small.height = divideUp(image.height, k);
  small.rgb.reserve(std::size_t{small.width} * small.height);
  for (std::uint32_t y = 0; y < small.height; ++y) {
    for (std::uint32_t x = 0; x < small.width; ++x) small.rgb.push_back(blockMean(image, x * k, y * k, k));
  }
  return small;
}

}  // namespace candela::report

// Averages the logarithm of the luminance.
#include "host/image/exposure.h"

#include <algorithm>
#include <cmath>

namespace candela::image {

float automaticExposure(const Image& image) {
  constexpr double kGrey = 0.18;
  double sum = 0;
  std::uint64_t count = 0;
  for (const glm::vec3& pixel : image.rgb) {
    const double y = luminance(glm::dvec3(pixel));
    if (!(y > 0) || !std::isfinite(y)) continue;
    sum += std::log2(y);
    ++count;
  }
  if (count == 0) return 0;
  return static_cast<float>(std::clamp(std::log2(kGrey) - sum / static_cast<double>(count), -64.0, 64.0));
}

}  // namespace candela::image

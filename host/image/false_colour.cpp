// False colours of depth and cost, and their scales.
#include "host/image/false_colour.h"

#include <algorithm>
#include <cmath>

#include "host/image/colour_map.h"

namespace candela::image {

bool isFalseColour(ToneMap toneMap) { return toneMap == ToneMap::depth || toneMap == ToneMap::heat; }

glm::dvec3 falseColour(double value, ToneMap toneMap) {
  if (toneMap == ToneMap::heat) return magma(value);
  return glm::dvec3(value > 0 ? 1 / (1 + value * value) : 0);
}

float falseColourScale(const Image& image, ToneMap toneMap) {
  std::vector<float> values;
  for (const glm::vec3& pixel : image.rgb) {
    if (std::isfinite(pixel.x) && pixel.x > 0) values.push_back(pixel.x);
  }
  if (values.empty()) return 1;
  if (toneMap == ToneMap::heat) return *std::max_element(values.begin(), values.end());
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace candela::image

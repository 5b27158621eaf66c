// The colours that stand for the values of layers.
#include <algorithm>
#include <cmath>
#include <vector>

#include "host/app/view/shown_layer.h"
#include "host/image/layers.h"

namespace candela::view {
namespace {

using image::Layer;

constexpr float kBrightestError = 0.25f;  // relative error that has the brightest colour without exposure

// A pixel without hits has the depth 1e10, and the position 0.
bool hasHit(const glm::vec4& pixel) {
  return pixel.w != 0 && pixel.x <= kMaxDepthOfHits && glm::vec3(pixel) != glm::vec3(0);
}

}  // namespace

// Ids are hashes already, so that their bits are independent. The golden ratio spreads the hues.
glm::vec3 idColour(std::uint32_t id) {
  if (id == image::kNoId) return glm::vec3(0);
  const std::uint32_t mixed = id * 0x9e3779b9u;
  const float hue = 6 * static_cast<float>(mixed >> 8) / (1u << 24);
  const float value = 0.6f + 0.4f * static_cast<float>(mixed >> 4 & 15) / 15;
  const float saturation = 0.45f + 0.4f * static_cast<float>(mixed & 15) / 15;
  const glm::vec3 pure = glm::clamp(glm::vec3(std::abs(hue - 3) - 1, 2 - std::abs(hue - 2), 2 - std::abs(hue - 4)),
                                    0.0f, 1.0f);
  return value * glm::mix(glm::vec3(1), pure, saturation);
}

LayerRange rangeOf(const Picture& picture) {
  std::vector<float> first;
  LayerRange range;
  for (const glm::vec4& pixel : picture.pixels) {
    if (!hasHit(pixel)) continue;
    const glm::vec3 value(pixel);
    range.minimum = first.empty() ? value : glm::min(range.minimum, value);
    range.maximum = first.empty() ? value : glm::max(range.maximum, value);
    first.push_back(value.x);
  }
  if (first.empty()) return {};
  const auto middle = first.begin() + static_cast<std::ptrdiff_t>(first.size() / 2);
  std::ranges::nth_element(first, middle);
  if (*middle > 0) range.median = *middle;
  return range;
}

LayerColours coloursOf(ShownLayer layer, const image::DisplayTransform& display, const LayerRange& range,
                       std::uint32_t sampleCount) {
  const float exposure = std::exp2(display.exposure);
  if (isLight(layer)) return {display.toneMap, glm::vec3(0), glm::vec3(exposure), display.scale, false};
  switch (*layer) {
    case Layer::normal:
      return {image::ToneMap::none, glm::vec3(-1), glm::vec3(0.5f)};
    case Layer::albedo:
      return {image::ToneMap::srgb};
    case Layer::depth:
      return {image::ToneMap::depth, glm::vec3(0), glm::vec3(1 / range.median)};
    case Layer::position:
      return {.toneMap = image::ToneMap::none,
              .offset = range.minimum,
              .gain = 1.0f / glm::max(range.maximum - range.minimum, glm::vec3(1e-30f)),
              .hidesZero = true};
    case Layer::uv:
      return {image::ToneMap::none, glm::vec3(0), glm::vec3(1), 1, true};
    case Layer::variance:
      return {image::ToneMap::heat, glm::vec3(0), glm::vec3(exposure), kBrightestError};
    case Layer::samples:
      return {image::ToneMap::heat, glm::vec3(0), glm::vec3(1), static_cast<float>(sampleCount)};
    default:
      return {image::ToneMap::none};  // mattes have colours
  }
}

glm::vec3 exposed(const glm::vec3& value, const LayerColours& colours) {
  if (colours.hidesZero && value == glm::vec3(0)) return value;
  const glm::vec3 scaled = (value - colours.offset) * colours.gain;
  return colours.repeats ? scaled - glm::floor(scaled) : scaled;
}

glm::u8vec3 toDisplay(const glm::vec3& value, const LayerColours& colours) {
  return image::toDisplay(exposed(value, colours), {colours.toneMap, 0, colours.scale});
}

}  // namespace candela::view

// The table of layers, their values, and their colours.
#include "host/view/shown_layer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "host/image/layers.h"

namespace candela::view {
namespace {

using image::Layer;

constexpr std::array kShown{Layer::normal,   Layer::albedo,       Layer::depth,          Layer::position,
                            Layer::uv,       Layer::direct,       Layer::indirect,       Layer::emission,
                            Layer::variance, Layer::cryptoObject, Layer::cryptoMaterial, Layer::samples};

constexpr float kBrightestError = 0.25f;  // relative error that has the brightest colour without exposure

float relativeError(const image::Film& film, std::uint32_t x, std::uint32_t y) {
  const double mean = image::luminance(film.mean(x, y));
  const double error = std::sqrt(film.luminanceVariance(x, y) / film.at(x, y).sampleCount);
  return mean > 0 ? static_cast<float>(error / mean) : 0;
}

glm::vec3 mixedColour(const image::IdCounts& counts, std::uint32_t samples) {
  glm::vec3 colour(0);
  for (const image::IdCount& entry : counts)
    colour += idColour(entry.id) * static_cast<float>(1.0 * entry.count / samples);
  return colour;
}

/// The values of a layer, for each pixel of a film.
class LayerValues {
 public:
  LayerValues(const image::Film& film, Layer layer) : film_(film), layer_(layer) {
    if (matteKindOf(layer)) return;
    for (std::size_t i = 0; i < layerChannelNames(layer).size(); ++i)
      channels_.push_back(layerChannelValues(film, layer, i));
  }

  /// The pixel must have samples.
  glm::vec3 at(std::uint32_t x, std::uint32_t y) const {
    const std::uint32_t samples = film_.at(x, y).sampleCount;
    if (layer_ == Layer::samples) return {samples, 0, 0};
    if (layer_ == Layer::variance) return {relativeError(film_, x, y), film_.luminanceVariance(x, y), 0};
    if (const auto kind = matteKindOf(layer_)) return mixedColour(film_.idsAt(*kind, x, y), samples);
    glm::vec3 value(0);
    const std::size_t pixel = std::size_t{y} * film_.width() + x;
    for (std::size_t i = 0; i < channels_.size(); ++i) value[static_cast<int>(i)] = channels_[i][pixel];
    return value;
  }

 private:
  const image::Film& film_;
  Layer layer_;
  std::vector<std::vector<float>> channels_;
};

// A pixel without hits has the depth 1e10, and the position 0.
bool hasHit(const glm::vec4& pixel) {
  return pixel.w != 0 && pixel.x <= kMaxDepthOfHits && glm::vec3(pixel) != glm::vec3(0);
}

}  // namespace

std::span<const Layer> shownLayers() { return kShown; }

std::string_view shownName(ShownLayer layer) {
  return layer ? image::layerNames()[static_cast<std::size_t>(*layer)] : "picture";
}

ShownLayer nextLayer(ShownLayer layer, bool isBackwards) {
  const auto found = layer ? std::ranges::find(kShown, *layer) - kShown.begin() + 1 : 0;
  const auto count = static_cast<std::ptrdiff_t>(kShown.size()) + 1;
  const std::ptrdiff_t next = (found + (isBackwards ? count - 1 : 1)) % count;
  return next == 0 ? std::nullopt : ShownLayer(kShown[static_cast<std::size_t>(next - 1)]);
}

bool isLight(ShownLayer layer) {
  return !layer || layer == Layer::direct || layer == Layer::indirect || layer == Layer::emission;
}

image::LayerSet neededBy(ShownLayer layer) {
  image::LayerSet layers;
  if (layer) layers.add(*layer);
  return layers;
}

void showLayer(const image::Film& film, Layer layer, Picture& picture) {
  const LayerValues values(film, layer);
  const auto kind = matteKindOf(layer);
  if (kind) picture.ids.resize(picture.pixels.size());
  forEachShown(film, picture, [&](std::size_t pixel, std::uint32_t x, std::uint32_t y, float samples) {
    picture.pixels[pixel] = glm::vec4(values.at(x, y), samples);
    if (kind) picture.ids[pixel] = film.idsAt(*kind, x, y);
  });
}

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

// The table of layers, and their values.
#include "host/app/view/shown_layer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "host/image/layers.h"

namespace candela::view {
namespace {

using image::Layer;

constexpr std::array kShown{Layer::normal,   Layer::albedo,       Layer::depth,          Layer::position,
                            Layer::uv,       Layer::direct,       Layer::indirect,       Layer::emission,
                            Layer::variance, Layer::cryptoObject, Layer::cryptoMaterial, Layer::samples};

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

}  // namespace candela::view

// Puts the channels of a layer side by side.
#include "host/app/python/film_layers.h"

#include <algorithm>

namespace candela::python {
namespace {

void interleave(const image::Image& image, const std::string& name, std::size_t index, LayerValues& layer) {
  const auto channel = std::ranges::find(image.channels, name, &image::Channel::name);
  for (std::size_t pixel = 0; pixel < channel->values.size(); ++pixel) {
    layer.values[pixel * layer.channels + index] = channel->values[pixel];
  }
}

LayerValues layerIn(const image::Image& image, std::span<const std::string> names) {
  LayerValues layer{names.size(), std::vector<float>(image.rgb.size() * names.size())};
  for (std::size_t i = 0; i < names.size(); ++i) interleave(image, names[i], i, layer);
  return layer;
}

}  // namespace

std::map<image::Layer, LayerValues> layersIn(const image::Image& image, image::LayerSet layers) {
  std::map<image::Layer, LayerValues> values;
  for (std::size_t i = 0; i < image::layerNames().size(); ++i) {
    const auto layer = static_cast<image::Layer>(i);
    const std::span<const std::string> names = image::layerChannelNames(layer);
    if (layers.has(layer) && !names.empty()) values[layer] = layerIn(image, names);
  }
  return values;
}

}  // namespace candela::python

// Renders with layers, and the channels of their films.
#pragma once
#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "host/image/image.h"
#include "tests/trace/render/both_tracers.h"

namespace candela::device {

inline image::LayerSet allLayers() {
  image::LayerSet layers;
  for (std::uint32_t i = 0; i < image::layerNames().size(); ++i) layers.add(static_cast<image::Layer>(i));
  return layers;
}

inline render::RenderSettings layerSettings(std::uint32_t side, std::uint32_t samples) {
  render::RenderSettings settings = squareSettings(side, samples);
  settings.image.layers = allLayers();
  return settings;
}

// One ray through the centre of each pixel.
inline render::RenderSettings centreSettings(std::uint32_t side) {
  render::RenderSettings settings = layerSettings(side, 1);
  settings.image.antialiasing = false;
  return settings;
}

/// The channels of a film's layers by name.
class Channels {
 public:
  explicit Channels(const image::Film& film) : width_(film.width()), image_(toImage(film)) { addLayers(image_, film); }

  double at(const std::string& name, std::uint32_t x, std::uint32_t y) const {
    const auto found = std::ranges::find(image_.channels, name, &image::Channel::name);
    REQUIRE(found != image_.channels.end());
    return double{found->values[std::size_t{y} * width_ + x]};
  }
  glm::dvec3 vectorAt(const std::string& layer, const char* letters, std::uint32_t x, std::uint32_t y) const {
    const auto channel = [&](int i) { return at(layer + "." + letters[i], x, y); };
    return {channel(0), channel(1), channel(2)};
  }
  const std::vector<image::Channel>& all() const { return image_.channels; }

 private:
  std::uint32_t width_;
  image::Image image_;
};

}  // namespace candela::device

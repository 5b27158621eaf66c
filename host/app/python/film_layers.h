// The layers of a film as values of NumPy arrays.
#pragma once
#include <map>
#include <vector>

#include "host/image/image.h"

namespace candela::python {

/// The values of a layer: `channels` numbers for each pixel, row by row from the top.
struct LayerValues {
  std::size_t channels = 0;
  std::vector<float> values;
};

/// Returns the layers of a film's image, which has the channels that image::addLayers() adds.
std::map<image::Layer, LayerValues> layersIn(const image::Image& image, image::LayerSet layers);

}  // namespace candela::python

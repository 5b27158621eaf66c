// The names of layers.
#include "host/image/layers.h"

#include <algorithm>

namespace candela::image {
namespace {

constexpr std::array<std::string_view, 13> kLayerNames{
    "normal",  "albedo",  "depth",         "position",       "uv", "direct", "indirect", "emission", "variance",
    "samples", "moments", "crypto-object", "crypto-material"};

}  // namespace

std::span<const std::string_view> layerNames() { return kLayerNames; }

LayerSet withSums(LayerSet layers) {
  LayerSet kept;
  for (std::uint32_t i = 0; i < kLayerNames.size(); ++i) {
    const auto layer = static_cast<Layer>(i);
    if (layers.has(layer) && layer != Layer::variance && layer != Layer::samples) kept.add(layer);
  }
  return kept;
}

bool hasMatte(LayerSet layers, MatteKind kind) {
  return layers.has(kind == MatteKind::object ? Layer::cryptoObject : Layer::cryptoMaterial);
}

std::optional<MatteKind> matteKindOf(Layer layer) {
  if (layer == Layer::cryptoObject) return MatteKind::object;
  if (layer == Layer::cryptoMaterial) return MatteKind::material;
  return std::nullopt;
}

bool hasMattes(LayerSet layers) {
  return std::ranges::any_of(kMatteKinds, [&](MatteKind kind) { return hasMatte(layers, kind); });
}

std::string layerText(LayerSet layers) {
  std::string text;
  for (std::size_t i = 0; i < kLayerNames.size(); ++i) {
    if (!layers.has(static_cast<Layer>(i))) continue;
    text += text.empty() ? "" : ",";
    text += kLayerNames[i];
  }
  return text.empty() ? "none" : text;
}

}  // namespace candela::image

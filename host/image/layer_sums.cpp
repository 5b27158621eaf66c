// The sums that layers need, and their records in a pixel.
#include <algorithm>
#include <array>

#include "host/image/layers.h"

namespace candela::image {
namespace {

struct SumSpan {
  LayerSum sum;
  std::string_view name;
  std::uint32_t count;
};
constexpr std::array kSums{
#define CANDELA_LIST_SUM(sum, has, row, bit, count) SumSpan{LayerSum::sum, #sum, count},
    CANDELA_LAYER_SUMS(CANDELA_LIST_SUM)
#undef CANDELA_LIST_SUM
};

constexpr std::uint32_t bitOf(LayerSum sum) { return static_cast<std::uint32_t>(sum); }

// Letters of a sum's channels.
std::string_view lettersOf(LayerSum sum) {
  switch (sum) {
    case LayerSum::normal:
    case LayerSum::position:
      return "XYZ";
    case LayerSum::depth:
      return "Z";
    case LayerSum::albedoSquared:
      return "Y";
    case LayerSum::texCoord:
      return "UV";
    default:
      return "RGB";
  }
}

std::uint32_t sumsOf(Layer layer) {
  switch (layer) {
    case Layer::normal:
      return bitOf(LayerSum::normal);
    case Layer::albedo:
      return bitOf(LayerSum::albedo);
    case Layer::depth:
      return bitOf(LayerSum::depth);
    case Layer::position:
      return bitOf(LayerSum::position);
    case Layer::uv:
      return bitOf(LayerSum::texCoord);
    case Layer::direct:
      return bitOf(LayerSum::unscattered) | bitOf(LayerSum::scatteredOnce);
    case Layer::indirect:
      return bitOf(LayerSum::scatteredOnce);
    case Layer::emission:
      return bitOf(LayerSum::unscattered);
    case Layer::moments:
      return bitOf(LayerSum::normal) | bitOf(LayerSum::albedo) | bitOf(LayerSum::rootRadiance) |
             bitOf(LayerSum::albedoSquared);
    case Layer::variance:
    case Layer::samples:
    case Layer::cryptoObject:
    case Layer::cryptoMaterial:
      break;
  }
  return 0;
}

}  // namespace

std::uint32_t layerSumsOf(LayerSet layers) {
  std::uint32_t sums = 0;
  for (std::uint32_t i = 0; i < layerNames().size(); ++i) {
    if (layers.has(static_cast<Layer>(i))) sums |= sumsOf(static_cast<Layer>(i));
  }
  return sums;
}

std::uint32_t layerRowCount(std::uint32_t sums) {
  std::uint32_t count = sums == 0 ? 0 : 1;
  for (const SumSpan& entry : kSums) count += (sums & bitOf(entry.sum)) != 0 ? entry.count : 0;
  return count;
}

std::uint32_t firstLayerRow(std::uint32_t sums, LayerSum sum) {
  const std::uint32_t before = sums & (bitOf(sum) - 1);
  return std::max(layerRowCount(before), 1u);
}

std::vector<std::string> layerSumNames(std::uint32_t sums) {
  std::vector<std::string> names;
  for (const SumSpan& entry : kSums) {
    if ((sums & bitOf(entry.sum)) == 0) continue;
    for (const char letter : lettersOf(entry.sum).substr(0, entry.count)) {
      names.push_back(std::string(entry.name) + '.' + letter);
    }
  }
  return names;
}

}  // namespace candela::image

// Layers in words: the key of their colours, and the values below the pointer.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/app/view/shown_layer.h"

namespace candela::view {
namespace {

using image::Layer;

std::string vectorText(const glm::vec3& value) {
  return fmt::format("{:.4g} {:.4g} {:.4g}", value.x, value.y, value.z);
}

}  // namespace

std::string keyText(ShownLayer layer, const image::DisplayTransform& display, const LayerRange& range,
                    std::uint32_t sampleCount) {
  const LayerColours colours = coloursOf(layer, display, range, sampleCount);
  switch (*layer) {
    case Layer::normal:
      return "colour = (1 + normal) / 2";
    case Layer::depth:
      return fmt::format("near is white; middle grey is {:.4g}", range.median);
    case Layer::position:
      return fmt::format("black: {}\nwhite: {}", vectorText(range.minimum), vectorText(range.maximum));
    case Layer::uv:
      return "red and green: fractions of u and v";
    case Layer::variance:
      return fmt::format("palest: relative error {:.3g} %", 100 * colours.scale / colours.gain.x);
    case Layer::samples:
      return fmt::format("palest: {} samples", sampleCount);
    case Layer::albedo:
      return "sRGB, without exposure";
    default:
      return "one colour for each name";
  }
}

std::string valueText(ShownLayer layer, const glm::vec3& value) {
  if (!layer) return vectorText(value);
  switch (*layer) {
    case Layer::depth:
      return value.x > kMaxDepthOfHits ? "nothing" : fmt::format("{:.5g}", value.x);
    case Layer::uv:
      return fmt::format("{:.4g} {:.4g}", value.x, value.y);
    case Layer::samples:
      return fmt::format("{:.0f}", value.x);
    case Layer::variance:
      return fmt::format("{:.4g}, error {:.3g} %", value.y, 100 * value.x);
    default:
      return vectorText(value);
  }
}

std::string matteText(const image::IdCounts& counts, const std::map<std::uint32_t, std::string>& names) {
  image::IdCounts sorted = counts;
  std::ranges::stable_sort(sorted, std::greater{}, &image::IdCount::count);
  const double samples = std::max(1u, sampleCountOf(counts));
  std::string text;
  for (std::size_t i = 0; i < std::min<std::size_t>(sorted.size(), 2); ++i) {
    const auto found = names.find(sorted[i].id);
    text += fmt::format("{}{} {:.0f} %", text.empty() ? "" : ", ", found == names.end() ? "nothing" : found->second,
                        100 * sorted[i].count / samples);
  }
  return text;
}

}  // namespace candela::view

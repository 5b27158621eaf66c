// The layers and mattes of a film's header as JSON.
#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "host/job/film/film_header_parts.h"

namespace candela::film {
namespace {

constexpr std::uint32_t kMaxSlots = 65536;
constexpr std::array kMatteMembers{"object", "material"};  // by MatteKind

}  // namespace

std::vector<std::string_view> layerNamesOf(image::LayerSet layers) {
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < image::layerNames().size(); ++i) {
    if (layers.has(static_cast<image::Layer>(i))) names.push_back(image::layerNames()[i]);
  }
  return names;
}

image::LayerSet layersIn(const JsonValue& root) {
  image::LayerSet layers;
  const std::optional<JsonValue> list = root.find("layers");
  if (!list) return layers;
  const std::span<const std::string_view> names = image::layerNames();
  for (const JsonValue& entry : list->items()) {
    const auto found = std::ranges::find(names, entry.text());
    if (found == names.end()) entry.fail("expected the name of a layer");
    layers.add(static_cast<image::Layer>(found - names.begin()));
  }
  if (layers != withSums(layers) || list->json() != nlohmann::json(layerNamesOf(layers))) {
    list->fail("expected layers with sums, in their order");
  }
  return layers;
}

nlohmann::ordered_json mattesJson(const FilmHeader& header) {
  nlohmann::ordered_json json;
  for (const image::MatteKind kind : image::kMatteKinds) {
    const auto index = static_cast<std::size_t>(kind);
    if (!hasMatte(header.layers, kind)) continue;
    json[kMatteMembers[index]] = {{"slots", header.matteSlots[index]}, {"names", header.matteNames[index]}};
  }
  return json;
}

void readMattes(const JsonValue& mattes, FilmHeader& header) {
  for (const image::MatteKind kind : image::kMatteKinds) {
    const auto index = static_cast<std::size_t>(kind);
    if (!hasMatte(header.layers, kind)) continue;
    const JsonValue matte = mattes.require(kMatteMembers[index]), names = matte.require("names");
    header.matteNames[index] = textsIn(names);
    header.matteSlots[index] = number(matte.require("slots"), 0, kMaxSlots);
    if (!isSortedSet(header.matteNames[index])) names.fail(kExpectsSortedSet);
  }
}

}  // namespace candela::film

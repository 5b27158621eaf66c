// The header of a film as JSON. Reading checks every value, since film files may come from anywhere.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <nlohmann/json.hpp>

#include "host/core/errors.h"
#include "host/film/film_header.h"
#include "host/image/image.h"

namespace candela::film {
namespace {

using nlohmann::ordered_json;
/// For reading: an ordered_json with n members takes n^2 steps to parse.
using Json = nlohmann::json;

constexpr std::uint32_t kLastFormat = 7;
constexpr std::uint32_t kMaxSlots = 65536;

ordered_json boxesJson(const std::vector<SampleBox>& boxes) {
  ordered_json json = ordered_json::array();
  for (const auto& [window, samples] : boxes) {
    json.push_back({window.x, window.y, window.width, window.height, samples.first, samples.end});
  }
  return json;
}

[[noreturn]] void refuse(const std::string& what) {
  throw FileError("the description of the film has no valid " + what);
}

std::string textAt(const Json& json, const char* key) {
  if (!json.is_object() || !json.contains(key) || !json[key].is_string()) refuse(key);
  return json[key];
}

const Json& listAt(const Json& json, const char* key) {
  if (!json.is_object() || !json.contains(key) || !json[key].is_array()) refuse(key);
  return json[key];
}

std::uint32_t number(const Json& json, const char* what, std::uint32_t lowest, std::uint32_t highest) {
  if (!json.is_number_unsigned()) refuse(what);
  const auto value = json.get<std::uint64_t>();
  if (value < lowest || value > highest) refuse(what);
  return static_cast<std::uint32_t>(value);
}

std::uint32_t numberAt(const Json& json, const char* key, std::uint32_t lowest, std::uint32_t highest) {
  if (!json.contains(key)) refuse(key);
  return number(json[key], key, lowest, highest);
}

render::Extent sizeAt(const Json& json) {
  const Json& list = listAt(json, "size");
  if (list.size() != 2) refuse("size");
  const render::Extent size{number(list[0], "size", 1, image::kMaxImageSide),
                            number(list[1], "size", 1, image::kMaxImageSide)};
  if (std::uint64_t{size.width} * size.height > image::kMaxImagePixels) refuse("size");
  return size;
}

render::Window windowFrom(const Json& list, const char* what, const render::Extent& size) {
  const render::Window window{number(list[0], what, 0, size.width - 1), number(list[1], what, 0, size.height - 1),
                              number(list[2], what, 1, size.width), number(list[3], what, 1, size.height)};
  if (!isWithin(window, size)) refuse(what);
  return window;
}

std::vector<SampleBox> boxesAt(const Json& json, const char* key, const FilmHeader& header) {
  const Json& list = listAt(json, key);
  if (list.size() > kMaxBoxes) refuse(key);
  std::vector<SampleBox> boxes;
  for (const Json& entry : list) {
    if (!entry.is_array() || entry.size() != 6) refuse(key);
    const render::Window window = windowFrom(entry, key, header.size);
    const std::uint32_t first = number(entry[4], key, 0, header.samplesPerPixel - 1);
    boxes.push_back({window, {first, number(entry[5], key, first + 1, header.samplesPerPixel)}});
  }
  return boxes;
}

std::vector<Tracer> tracersAt(const Json& json) {
  std::vector<Tracer> tracers;
  for (const Json& entry : listAt(json, "tracers")) {
    tracers.push_back({textAt(entry, "device"), textAt(entry, "driver"), textAt(entry, "platform"),
                       textAt(entry, "kernels"), textAt(entry, "program")});
  }
  return tracers;
}

std::map<std::string, std::string> settingsAt(const Json& json) {
  if (!json.contains("settings") || !json["settings"].is_object()) refuse("settings");
  std::map<std::string, std::string> settings;
  for (const auto& [name, value] : json["settings"].items()) {
    if (!value.is_string()) refuse("settings");
    settings[name] = value;
  }
  return settings;
}

std::vector<std::string_view> layerNamesOf(image::LayerSet layers) {
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < image::layerNames().size(); ++i) {
    if (layers.has(static_cast<image::Layer>(i))) names.push_back(image::layerNames()[i]);
  }
  return names;
}

// The list has the names of layers with sums in the order of image::Layer, and is absent if there are none.
image::LayerSet layersAt(const Json& json) {
  image::LayerSet layers;
  if (!json.contains("layers")) return layers;
  const std::span<const std::string_view> names = image::layerNames();
  for (const Json& entry : listAt(json, "layers")) {
    if (!entry.is_string()) refuse("layers");
    const auto place = std::ranges::find(names, entry.get<std::string>());
    if (place == names.end()) refuse("layers");
    layers.add(static_cast<image::Layer>(place - names.begin()));
  }
  if (layers != withSums(layers) || json["layers"] != Json(layerNamesOf(layers))) refuse("layers");
  return layers;
}

constexpr std::array kMatteMembers{"object", "material"};  // by MatteKind

ordered_json mattesJson(const FilmHeader& header) {
  ordered_json json;
  for (const image::MatteKind kind : image::kMatteKinds) {
    const auto index = static_cast<std::size_t>(kind);
    if (!hasMatte(header.layers, kind)) continue;
    json[kMatteMembers[index]] = {{"slots", header.matteSlots[index]}, {"names", header.matteNames[index]}};
  }
  return json;
}

void readMattes(const Json& json, FilmHeader& header) {
  if (!json.contains("mattes") || !json["mattes"].is_object()) refuse("mattes");
  for (const image::MatteKind kind : image::kMatteKinds) {
    const auto index = static_cast<std::size_t>(kind);
    if (!hasMatte(header.layers, kind)) continue;
    if (!json["mattes"].contains(kMatteMembers[index])) refuse("mattes");
    const Json& matte = json["mattes"][kMatteMembers[index]];
    for (const Json& name : listAt(matte, "names")) {
      if (!name.is_string()) refuse("mattes");
      header.matteNames[index].push_back(name);
    }
    header.matteSlots[index] = numberAt(matte, "slots", 0, kMaxSlots);
    if (std::ranges::adjacent_find(header.matteNames[index], std::greater_equal{}) != header.matteNames[index].end()) {
      refuse("mattes");
    }
  }
}

std::vector<std::string> mixedAt(const Json& json) {
  std::vector<std::string> lines;
  for (const Json& line : listAt(json, "mixed")) {
    if (!line.is_string()) refuse("mixed");
    lines.push_back(line);
  }
  return lines;
}

template <class T>
bool isSortedSet(const std::vector<T>& items) {
  return std::ranges::adjacent_find(items, [](const T& a, const T& b) { return !(a < b); }) == items.end();
}

bool liesWithin(const render::Window& inner, const render::Window& outer) {
  return inner.x >= outer.x && inner.y >= outer.y && inner.x + inner.width <= outer.x + outer.width &&
         inner.y + inner.height <= outer.y + outer.height;
}

void checkBoxes(const std::vector<SampleBox>& boxes, const FilmHeader& header, const char* what) {
  const auto isInside = [&](const SampleBox& box) { return liesWithin(box.window, header.window); };
  if (!std::ranges::all_of(boxes, isInside) || !isCanonical(boxes)) refuse(what);
}

void checkBothLists(const FilmHeader& header) {
  checkBoxes(header.covered, header, "covered");
  checkBoxes(header.begun, header, "begun");
  std::vector<SampleBox> all = header.covered;
  all.insert(all.end(), header.begun.begin(), header.begun.end());
  if (all.size() > kMaxBoxes) refuse("begun");
  try {
    requireDisjoint(all);
  } catch (const Error&) {
    refuse("begun");
  }
}

void check(const FilmHeader& header) {
  const bool isHash = header.sceneHash.size() == 16 &&
                      header.sceneHash.find_first_not_of("0123456789abcdef") == std::string::npos;
  if (!isHash) refuse("scene");
  checkBothLists(header);
  if (header.tracers.empty() || !isSortedSet(header.tracers)) refuse("tracers");
  if (!isSortedSet(header.mixed)) refuse("mixed");
  static_cast<void>(header.filmScale());
  const auto rule = header.settings.find(kStoppingRule);
  const bool hasRule = rule != header.settings.end();
  if (hasRule && (rule->second != kCurrentStoppingRule || !header.noiseThreshold())) refuse("settings");
  if (header.noiseThreshold() && header.samplesPerPixel <= render::pilotSamples(*header.noiseThreshold()))
    refuse("samplesPerPixel");
}

Json parsed(const std::string& text) {
  Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) throw FileError("the description of the film is not JSON");
  const std::uint32_t format = numberAt(json, "format", 0, 0xffffffffu);
  if (format < 1 || format > kLastFormat) {
    throw FileError(fmt::format("the film file has version {} of the format, and this program reads versions 1 to {}",
                                format, kLastFormat));
  }
  return json;
}

}  // namespace

ordered_json tracersJson(const std::vector<Tracer>& tracers) {
  ordered_json json = ordered_json::array();
  for (const Tracer& tracer : tracers) {
    json.push_back({{"device", tracer.device},
                    {"driver", tracer.driver},
                    {"platform", tracer.platform},
                    {"kernels", tracer.kernels},
                    {"program", tracer.program}});
  }
  return json;
}

std::string validText(const std::string& text) {
  return ordered_json::parse(ordered_json(text).dump(-1, ' ', true, ordered_json::error_handler_t::replace));
}

std::string toJson(const FilmHeader& header) {
  ordered_json json;
  json["format"] = header.format();
  json["scene"] = header.sceneHash;
  json["size"] = {header.size.width, header.size.height};
  json["samplesPerPixel"] = header.samplesPerPixel;
  json["seed"] = header.seed;
  json["settings"] = header.settings;
  if (!header.layers.isEmpty()) json["layers"] = layerNamesOf(header.layers);
  if (hasMattes(header.layers)) json["mattes"] = mattesJson(header);
  json["window"] = {header.window.x, header.window.y, header.window.width, header.window.height};
  json["covered"] = boxesJson(header.covered);
  json["begun"] = boxesJson(header.begun);
  json["tracers"] = tracersJson(header.tracers);
  json["mixed"] = header.mixed;
  return json.dump(-1, ' ', true);
}

FilmHeader headerFromJson(const std::string& text) {
  const Json json = parsed(text);
  FilmHeader header;
  header.sceneHash = textAt(json, "scene");
  header.size = sizeAt(json);
  header.samplesPerPixel = numberAt(json, "samplesPerPixel", 1, render::kMaxSampleCount);
  header.seed = numberAt(json, "seed", 0, 0xffffffffu);
  header.settings = settingsAt(json);
  header.layers = layersAt(json);
  if (json["format"] != header.format()) refuse("format");
  if (hasMattes(header.layers)) readMattes(json, header);
  if (listAt(json, "window").size() != 4) refuse("window");
  header.window = windowFrom(json["window"], "window", header.size);
  header.covered = boxesAt(json, "covered", header);
  header.begun = boxesAt(json, "begun", header);
  header.tracers = tracersAt(json);
  header.mixed = mixedAt(json);
  check(header);
  return header;
}

}  // namespace candela::film

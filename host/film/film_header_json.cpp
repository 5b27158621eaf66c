// The header of a film as JSON. Reading checks every value, since film files may come from anywhere.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "host/core/json_text.h"
#include "host/core/json_value.h"
#include "host/core/utf8.h"
#include "host/film/film_header.h"
#include "host/image/image.h"

namespace candela::film {
namespace {

using nlohmann::ordered_json;
/// For reading: an ordered_json with n members takes n^2 steps to parse.
using Json = nlohmann::json;

constexpr std::uint32_t kLastFormat = 7;
constexpr std::uint32_t kMaxSlots = 65536;
constexpr const char* kExpectsSortedSet = "expected different elements in ascending order";

ordered_json boxesJson(const std::vector<SampleBox>& boxes) {
  ordered_json json = ordered_json::array();
  for (const auto& [window, samples] : boxes) {
    json.push_back({window.x, window.y, window.width, window.height, samples.first, samples.end});
  }
  return json;
}

std::uint32_t number(const JsonValue& value, std::uint32_t min, std::uint32_t max) {
  return static_cast<std::uint32_t>(value.whole(min, max));
}

void requireSize(const JsonValue& list, std::size_t size) {
  if (list.size() != size) list.fail(fmt::format("expected {} elements", size));
}

render::Extent sizeIn(const JsonValue& list) {
  requireSize(list, 2);
  const render::Extent size{number(list[0], 1, image::kMaxImageSide), number(list[1], 1, image::kMaxImageSide)};
  if (std::uint64_t{size.width} * size.height > image::kMaxImagePixels) list.fail("the image has too many pixels");
  return size;
}

// The first four elements of the list are the window.
render::Window windowIn(const JsonValue& list, const render::Extent& size) {
  const render::Window window{number(list[0], 0, size.width - 1), number(list[1], 0, size.height - 1),
                              number(list[2], 1, size.width), number(list[3], 1, size.height)};
  if (!isWithin(window, size)) list.fail("the window exceeds the image");
  return window;
}

std::vector<SampleBox> boxesIn(const JsonValue& list, const FilmHeader& header) {
  if (list.size() > kMaxBoxes) list.fail(fmt::format("expected at most {} boxes", kMaxBoxes));
  std::vector<SampleBox> boxes;
  for (const JsonValue& entry : list.items()) {
    requireSize(entry, 6);
    const render::Window window = windowIn(entry, header.size);
    const std::uint32_t first = number(entry[4], 0, header.samplesPerPixel - 1);
    boxes.push_back({window, {first, number(entry[5], first + 1, header.samplesPerPixel)}});
  }
  return boxes;
}

std::vector<Tracer> tracersIn(const JsonValue& list) {
  std::vector<Tracer> tracers;
  for (const JsonValue& entry : list.items()) {
    tracers.push_back({entry.require("device").text(), entry.require("driver").text(), entry.require("platform").text(),
                       entry.require("kernels").text(), entry.require("program").text()});
  }
  return tracers;
}

std::map<std::string, std::string> settingsIn(const JsonValue& object) {
  std::map<std::string, std::string> settings;
  for (const std::string& name : object.keys()) settings[name] = object.require(name).text();
  return settings;
}

std::vector<std::string> textsIn(const JsonValue& list) {
  std::vector<std::string> texts;
  for (const JsonValue& entry : list.items()) texts.push_back(entry.text());
  return texts;
}

std::vector<std::string_view> layerNamesOf(image::LayerSet layers) {
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < image::layerNames().size(); ++i) {
    if (layers.has(static_cast<image::Layer>(i))) names.push_back(image::layerNames()[i]);
  }
  return names;
}

// The list has the names of layers with sums in the order of image::Layer, and is absent if there are none.
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
  if (layers != withSums(layers) || list->json() != Json(layerNamesOf(layers))) {
    list->fail("expected layers with sums, in their order");
  }
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

template <class T>
bool isSortedSet(const std::vector<T>& items) {
  return std::ranges::adjacent_find(items, [](const T& a, const T& b) { return !(a < b); }) == items.end();
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

bool liesWithin(const render::Window& inner, const render::Window& outer) {
  return inner.x >= outer.x && inner.y >= outer.y && inner.x + inner.width <= outer.x + outer.width &&
         inner.y + inner.height <= outer.y + outer.height;
}

void checkBoxes(const std::vector<SampleBox>& boxes, const FilmHeader& header, const JsonValue& list) {
  const auto isInside = [&](const SampleBox& box) { return liesWithin(box.window, header.window); };
  if (!std::ranges::all_of(boxes, isInside)) list.fail("a box exceeds the window");
  if (!isCanonical(boxes)) list.fail("the boxes overlap, or are not in the form that is written");
}

void checkBothLists(const FilmHeader& header, const JsonValue& root) {
  const JsonValue begun = root.require("begun");
  checkBoxes(header.covered, header, root.require("covered"));
  checkBoxes(header.begun, header, begun);
  std::vector<SampleBox> all = header.covered;
  all.insert(all.end(), header.begun.begin(), header.begun.end());
  if (all.size() > kMaxBoxes) begun.fail(fmt::format("expected at most {} boxes in both lists", kMaxBoxes));
  try {
    requireDisjoint(all);
  } catch (const Error&) {
    begun.fail("the boxes overlap those of \"covered\"");
  }
}

void check(const FilmHeader& header, const JsonValue& root) {
  const bool isHash = header.sceneHash.size() == 16 &&
                      header.sceneHash.find_first_not_of("0123456789abcdef") == std::string::npos;
  if (!isHash) root.require("scene").fail("expected 16 hexadecimal digits");
  checkBothLists(header, root);
  if (header.tracers.empty()) root.require("tracers").fail("expected at least one tracer");
  if (!isSortedSet(header.tracers)) root.require("tracers").fail(kExpectsSortedSet);
  if (!isSortedSet(header.mixed)) root.require("mixed").fail(kExpectsSortedSet);
  static_cast<void>(header.filmScale());
  const auto rule = header.settings.find(kStoppingRule);
  const bool hasRule = rule != header.settings.end();
  if (hasRule && (rule->second != kCurrentStoppingRule || !header.noiseThreshold())) {
    root.require("settings").require(kStoppingRule).fail("the rule is unknown, or there is no noise threshold");
  }
  if (header.noiseThreshold() && header.samplesPerPixel <= render::pilotSamples(*header.noiseThreshold())) {
    root.require("samplesPerPixel").fail("too few samples for the noise threshold");
  }
}

void requireFormat(const JsonValue& value) {
  const std::uint32_t format = number(value, 0, 0xffffffffu);
  if (format >= 1 && format <= kLastFormat) return;
  throw FileError(fmt::format("the film file has version {} of the format, and this program reads versions 1 to {}",
                              format, kLastFormat));
}

FilmHeader headerIn(const JsonValue& root) {
  const JsonValue format = root.require("format");
  requireFormat(format);
  FilmHeader header;
  header.sceneHash = root.require("scene").text();
  header.size = sizeIn(root.require("size"));
  header.samplesPerPixel = number(root.require("samplesPerPixel"), 1, render::kMaxSampleCount);
  header.seed = number(root.require("seed"), 0, 0xffffffffu);
  header.settings = settingsIn(root.require("settings"));
  header.layers = layersIn(root);
  if (format.whole() != header.format()) {
    format.fail(fmt::format("a film with these settings and layers has version {}", header.format()));
  }
  if (hasMattes(header.layers)) readMattes(root.require("mattes"), header);
  const JsonValue window = root.require("window");
  requireSize(window, 4);
  header.window = windowIn(window, header.size);
  header.covered = boxesIn(root.require("covered"), header);
  header.begun = boxesIn(root.require("begun"), header);
  header.tracers = tracersIn(root.require("tracers"));
  header.mixed = textsIn(root.require("mixed"));
  check(header, root);
  return header;
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
  std::string valid;
  for (std::string_view rest = text; !rest.empty();) {
    const Utf8Character character = firstCharacter(rest);
    valid += character.isValid ? character.bytes : kReplacementCharacter;
    rest.remove_prefix(character.bytes.size());
  }
  return valid;
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
  return asciiJsonText(json);
}

FilmHeader headerFromJson(const std::string& text) {
  constexpr const char* kMessage = "the description of the film: {}";
  try {
    const Json json = parseJson(text);
    return headerIn(JsonValue(json, ""));
  } catch (const JsonSyntaxError& error) {
    throw FileError(fmt::format(kMessage, error.what()));
  } catch (const JsonError& error) {
    throw FileError(fmt::format(kMessage, error.what()));
  }
}

}  // namespace candela::film

// Reads the header of a film from JSON, and checks every value, since film files may come from anywhere.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "host/base/errors.h"
#include "host/base/json_text.h"
#include "host/image/image.h"
#include "host/job/film/film_header_parts.h"

namespace candela::film {
namespace {

constexpr std::uint32_t kLastFormat = 7;

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
  checkHeader(header, root);
  return header;
}

}  // namespace

FilmHeader headerFromJson(const std::string& text) {
  constexpr const char* kMessage = "the description of the film: {}";
  try {
    const nlohmann::json json = parseJson(text);
    return headerIn(JsonValue(json, ""));
  } catch (const JsonSyntaxError& error) {
    throw FileError(fmt::format(kMessage, error.what()));
  } catch (const JsonError& error) {
    throw FileError(fmt::format(kMessage, error.what()));
  }
}

}  // namespace candela::film

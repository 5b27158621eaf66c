// Writes the header of a film as JSON.
#include <nlohmann/json.hpp>

#include "host/base/json_text.h"
#include "host/job/film/film_header_parts.h"

namespace candela::film {
namespace {

using nlohmann::ordered_json;

ordered_json boxesJson(const std::vector<SampleBox>& boxes) {
  ordered_json json = ordered_json::array();
  for (const auto& [window, samples] : boxes) {
    json.push_back({window.x, window.y, window.width, window.height, samples.first, samples.end});
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

}  // namespace candela::film

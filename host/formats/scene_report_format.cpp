// Formats a scene report as text and as JSON.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "host/base/hash_text.h"
#include "host/formats/scene_report.h"

namespace candela::scene {
namespace {

using nlohmann::json;

json toJson(const glm::vec3& v) { return {v.x, v.y, v.z}; }

json toJson(const Camera& camera) {
  json object{{"from", toJson(camera.from)},
              {"at", toJson(camera.at)},
              {"up", toJson(camera.up)},
              {"angle", camera.angle},
              {"hither", camera.hither},
              {"size", fmt::format("{}x{}", camera.width, camera.height)},
              {"aperture", camera.aperture},
              {"focal", camera.focal},
              {"shift", {camera.shift.x, camera.shift.y}},
              {"mirrored", camera.isMirrored}};
  if (camera.orthographicHeight) {
    object.erase("angle");
    object["orthographicHeight"] = *camera.orthographicHeight;
  }
  return object;
}

template <typename Value, typename Convert>
json orNull(const std::optional<Value>& value, Convert convert) {
  return value ? convert(*value) : json(nullptr);
}

std::string toText(RequestedAccel accel) { return kRequestedAccelNames[static_cast<std::size_t>(accel)]; }

std::string toText(const PixelFilter& filter) {
  if (filter.kind == FilterKind::gaussian) return fmt::format("gaussian:{}", filter.deviation);
  return filter.kind == FilterKind::box ? "box" : "tent";
}

std::string toText(const glm::vec3& v) { return fmt::format("{:g} {:g} {:g}", v.x, v.y, v.z); }

std::string toText(const Camera& c) {
  const std::string view = c.orthographicHeight ? fmt::format("orthographic height {:g}", *c.orthographicHeight)
                                                : fmt::format("angle {:g}", c.angle);
  const std::string shift = c.shift == glm::vec2(0) ? "" : fmt::format(", shift {:g} {:g}", c.shift.x, c.shift.y);
  return fmt::format("from {}, at {}, up {}, {}, {} x {}, aperture {:g}, focal {:g}{}{}", toText(c.from), toText(c.at),
                     toText(c.up), view, c.width, c.height, c.aperture, c.focal, shift,
                     c.isMirrored ? ", mirrored" : "");
}

// Returns "point light" for "pointLight".
std::string wordsOf(const std::string& identifier) {
  std::string words;
  for (const char c : identifier) {
    const bool isCapital = c >= 'A' && c <= 'Z';
    if (isCapital) words += ' ';
    words += isCapital ? static_cast<char>(c | 0x20) : c;
  }
  return words;
}

std::string statementsText(const StatementCounts& counts) {
  std::string text;
  for (const auto& [kind, count] : counts) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", wordsOf(kind), count);
  }
  return text.empty() ? "none" : text;
}

std::string memoryText(const SceneMemory& memory) {
  std::string text = fmt::format("{} bytes", memory.total);
  if (const auto perTriangle = memory.bytesPerTriangle())
    text += fmt::format("; {:.1f} bytes per triangle", *perTriangle);
  if (memory.textures > 0) text += fmt::format("; {} bytes of textures", memory.textures);
  if (memory.deepTextures > 0) text += fmt::format(", {} of them for 16-bit channels", memory.deepTextures);
  return text;
}

/// Spot and directional lights, which only some formats have, appear if there are any.
std::string lightsText(const SceneReport::Lights& lights) {
  std::string text = fmt::format("{}: spheres {}, triangles {}, cones {}, planes {}, points {}", lights.total(),
                                 lights.spheres, lights.triangles, lights.cones, lights.planes, lights.points);
  if (lights.spots > 0) text += fmt::format(", spots {}", lights.spots);
  if (lights.directionals > 0) text += fmt::format(", directional {}", lights.directionals);
  return text;
}

}  // namespace

std::string toText(const SceneReport& r) {
  const auto& [spheres, triangles, boxes, cones, planes] = r.primitives;
  const auto& lights = r.lights;
  const auto& materials = r.materials;
  std::string text = r.name + '\n';
  const auto line = [&](std::string_view label, const std::string& value) {
    text += fmt::format("  {:<12}{}\n", label, value);
  };
  line("statements", statementsText(r.statements));
  for (const auto& [label, value] : r.facts) line(label, value);
  line("primitives", fmt::format("{}: spheres {}, triangles {}, boxes {}, cones {}, planes {}", r.primitives.total(),
                                 spheres, triangles, boxes, cones, planes));
  line("bounds", r.bounds ? fmt::format("{} to {}", toText(r.bounds->min), toText(r.bounds->max)) : "none");
  line("lights", lightsText(lights));
  line("materials",
       fmt::format("{}: diffuse {}, glossy {}, mirror {}, dielectric {}, mixture {}, surface {}, black {}; {} emit",
                   materials.total(), materials.diffuse, materials.glossy, materials.mirror, materials.dielectric,
                   materials.mixture, materials.surface, materials.black, materials.emitting));
  for (const std::string& value : linesOf(r.coincident)) line("coincident", value);
  line("camera", r.camera ? toText(*r.camera) : "none");
  if (r.filmScale > 0) line("film scale", fmt::format("2^{}, because of strong lights", r.filmScale));
  line("background", r.skySide ? fmt::format("sky box, faces up to {} texels", *r.skySide) : toText(r.background));
  if (r.requestedAccel) line("accel", fmt::format("{} requested", toText(*r.requestedAccel)));
  if (r.requestedSamples) line("spp", fmt::format("{} requested", *r.requestedSamples));
  if (r.requestedMaxDepth) line("max depth", fmt::format("{} requested", *r.requestedMaxDepth));
  if (r.requestedFilter) line("filter", fmt::format("{} requested", toText(*r.requestedFilter)));
  if (r.requestedCrop) line("crop", fmt::format("{} requested", windowText(*r.requestedCrop)));
  line("memory", memoryText(r.memory));
  line("hash", hashText(r.hash));
  for (const std::string& warning : r.warnings) line("warning", warning);
  return text;
}

json toJson(const SceneReport& r) {
  const auto same = [](const auto& value) { return json(value); };
  const auto bounds = [](const Bounds& b) { return json{{"min", toJson(b.min)}, {"max", toJson(b.max)}}; };
  const auto camera = [](const Camera& c) { return toJson(c); };
  json coincident = json::array();
  for (const CoincidentObjects& pair : r.coincident.pairs) {
    coincident.push_back({{"objects", {pair.first, pair.second}},
                          {"oneObject", pair.isOne},
                          {"copies", pair.copies.second},
                          {"overlaps", pair.overlaps.second}});
  }
  return {
      {"scene", r.name},
      {"sceneHash", hashText(r.hash)},
      {"statements", r.statements},
      {"facts", std::map<std::string, std::string>(r.facts.begin(), r.facts.end())},
      {"primitives",
       {{"total", r.primitives.total()},
        {"spheres", r.primitives.spheres},
        {"triangles", r.primitives.triangles},
        {"boxes", r.primitives.boxes},
        {"cones", r.primitives.cones},
        {"planes", r.primitives.planes}}},
      {"bounds", orNull(r.bounds, bounds)},
      {"lights",
       {{"total", r.lights.total()},
        {"spheres", r.lights.spheres},
        {"triangles", r.lights.triangles},
        {"cones", r.lights.cones},
        {"planes", r.lights.planes},
        {"points", r.lights.points},
        {"spots", r.lights.spots},
        {"directional", r.lights.directionals}}},
      {"materials",
       {{"total", r.materials.total()},
        {"diffuse", r.materials.diffuse},
        {"glossy", r.materials.glossy},
        {"mirror", r.materials.mirror},
        {"dielectric", r.materials.dielectric},
        {"mixture", r.materials.mixture},
        {"surface", r.materials.surface},
        {"black", r.materials.black},
        {"emitting", r.materials.emitting}}},
      {"coincident", coincident},
      {"coincidentPrimitives", orNull(r.coincident.primitiveCount, same)},
      {"camera", orNull(r.camera, camera)},
      {"background", toJson(r.background)},
      {"skySide", orNull(r.skySide, same)},
      {"filmScale", r.filmScale},
      {"requestedAccel", orNull(r.requestedAccel, [](RequestedAccel accel) { return json(toText(accel)); })},
      {"requestedSamplesPerPixel", orNull(r.requestedSamples, same)},
      {"requestedMaxDepth", orNull(r.requestedMaxDepth, same)},
      {"requestedFilter", orNull(r.requestedFilter, [](const PixelFilter& filter) { return json(toText(filter)); })},
      {"requestedCrop", orNull(r.requestedCrop, [](const Window& crop) { return json(windowText(crop)); })},
      {"memory", toJson(r.memory)},
      {"warnings", r.warnings},
  };
}

}  // namespace candela::scene

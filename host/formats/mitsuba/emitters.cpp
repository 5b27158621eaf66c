// Converts emitters.
#include "host/formats/mitsuba/emitters.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "host/base/errors.h"
#include "host/base/quote.h"
#include "host/formats/mitsuba/names.h"
#include "host/formats/mitsuba/transform.h"
#include "host/scene/environment/environment.h"

namespace candela::mitsuba {
namespace {

using scene::PunctualLight;
using scene::quote;

constexpr std::array<std::string_view, 8> kOtherEmitters{
    "projector", "sunsky", "sun", "sky", "timed_sunsky", "directionalarea", "collimated", "volumelight"};

/// 1 - cos, without cancellation.
double versine(double angle) { return 2 * std::pow(std::sin(angle / 2), 2); }

/// The inner angle, as 1 - cos, for which glTF's spot light has the power of Mitsuba's. With v = 1 - cos, glTF's
/// intensity rises from the outer angle o to the inner one i as ((o - v)/(o - i))^2, so that the power is 2 pi (i + (o
/// - i)/3). Mitsuba's rises linearly in the angle from the cutoff c to the beam width b: 2 pi (1 - (sin c - sin b)/(c -
/// b)).
double innerVersine(double cutoff, double beam) {
  const double power = cutoff > beam ? 1 - (std::sin(cutoff) - std::sin(beam)) / (cutoff - beam) : versine(cutoff);
  return std::clamp((3 * power - versine(cutoff)) / 2, 0.0, versine(cutoff));
}

}  // namespace

Texture areaEmission(const Object& emitter, Textures& textures, Report& report) {
  if (emitter.type != "area") {
    throw PlacedError{emitter.place, fmt::format("a shape has an emitter \"area\" instead of {}", quote(emitter.type))};
  }
  emitter.ignore({"sampling_weight"}, report);
  Texture radiance = textures.read(emitter, "radiance", 1, ColourUse::emission, Encoding::srgb);
  emitter.reportUnused(report);
  return radiance;
}

glm::dvec3 Emitters::colour(const Object& emitter, const char* name) {
  const Property* const property = emitter.find(name);
  return property ? colourOf(*property, ColourUse::emission, report_) : glm::dvec3(1);
}

void Emitters::add(const Object& emitter) {
  emitter.ignore({"sampling_weight"}, report_);
  if (emitter.type == "point") {
    addPoint(emitter);
  } else if (emitter.type == "spot") {
    addSpot(emitter);
  } else if (emitter.type == "directional") {
    addDirectional(emitter);
  } else if (emitter.type == "constant") {
    addConstant(emitter);
  } else if (emitter.type == "envmap") {
    addEnvironment(emitter);
  } else if (emitter.type == "area") {
    throw PlacedError{emitter.place, "an emitter \"area\" belongs to a shape"};
  } else if (std::ranges::count(kOtherEmitters, emitter.type) > 0) {
    report_.deviate(emitter.place, fmt::format("{} is not rendered", emitter.description()), "leaves it out");
    return;
  } else {
    constexpr std::array<std::string_view, 6> kRendered{"point", "spot", "directional", "constant", "envmap", "area"};
    throw PlacedError{emitter.place,
                      fmt::format("unknown emitter {}{}", quote(emitter.type), suggestionFor(emitter.type, kRendered))};
  }
  emitter.reportUnused(report_);
}

void Emitters::addPoint(const Object& emitter) {
  PunctualLight light;
  const glm::dmat4 map = emitter.transform("to_world");
  light.position = glm::vec3(emitter.vector("position", placed(map, glm::dvec3(0))));
  light.intensity = glm::vec3(colour(emitter, "intensity"));
  scene_.punctualLights.push_back(light);
}

void Emitters::addSpot(const Object& emitter) {
  PunctualLight light;
  light.kind = PunctualLight::Kind::spot;
  const glm::dmat4 map = emitter.transform("to_world");
  const glm::dvec3 direction = turned(map, {0, 0, 1});
  if (!(glm::length(direction) > 0)) throw PlacedError{emitter.place, "the transform of the light has no direction"};
  light.position = glm::vec3(placed(map, glm::dvec3(0)));
  light.direction = glm::vec3(glm::normalize(direction));
  light.intensity = glm::vec3(colour(emitter, "intensity"));
  const double cutoff = emitter.number("cutoff_angle", 20);
  const double beam = emitter.number("beam_width", cutoff * 3 / 4);
  if (!(cutoff > 0 && cutoff <= 90 && beam >= 0 && beam <= cutoff)) {
    throw PlacedError{emitter.place, "\"cutoff_angle\" is above 0 and at most 90, and \"beam_width\" between 0 and it"};
  }
  light.versineOuter = static_cast<float>(versine(glm::radians(cutoff)));
  light.versineInner = std::min(static_cast<float>(innerVersine(glm::radians(cutoff), glm::radians(beam))),
                                std::nextafter(light.versineOuter, 0.0f));
  if (beam < cutoff) {
    report_.omit(
        "the linear fall-off of emitter \"spot\" between beam_width and cutoff_angle, instead of which it has glTF's "
        "with the same power");
  }
  if (const Property* const texture = emitter.find("texture")) {
    report_.deviate(texture->place, "the texture of a spot light is not rendered", "leaves it out");
  }
  scene_.punctualLights.push_back(light);
}

void Emitters::addDirectional(const Object& emitter) {
  PunctualLight light;
  light.kind = PunctualLight::Kind::directional;
  const glm::dvec3 direction = emitter.vector("direction", turned(emitter.transform("to_world"), {0, 0, 1}));
  if (!(glm::length(direction) > 0)) throw PlacedError{emitter.place, "the direction of the light has no length"};
  light.direction = glm::vec3(glm::normalize(direction));
  light.intensity = glm::vec3(colour(emitter, "irradiance"));
  scene_.punctualLights.push_back(light);
}

void Emitters::addSurrounding(const Object& emitter) {
  if (isSurrounded_) throw PlacedError{emitter.place, "the scene has a second environment"};
  isSurrounded_ = true;
}

void Emitters::addConstant(const Object& emitter) {
  addSurrounding(emitter);
  scene_.background = glm::vec3(colour(emitter, "radiance"));
}

// Mitsuba's map has the direction -z in the middle of its left edge, and +x at a quarter of its width; Candela's has
// -x and -z there.
void Emitters::addEnvironment(const Object& emitter) {
  addSurrounding(emitter);
  emitter.ignore({"mis_compensation", "cache"}, report_);
  const double scale = emitter.number("scale", 1);
  if (!(scale >= 0 && scale <= 1e30))
    throw PlacedError{emitter.place, "the scale of the environment is outside of 0 to 1e30"};
  const glm::dmat4 map = emitter.transform("to_world");
  const std::string name = emitter.text("filename", "");
  if (name.empty()) throw PlacedError{emitter.place, "the environment has no \"filename\""};
  if (!isSimilarity(map)) throw PlacedError{emitter.place, "the transform of the environment does not preserve angles"};
  if (options_.hasEnvironment()) return;
  const std::filesystem::path path = findFile(name, *emitter.place.document, description_, file_.folder);
  try {
    guard_.require(path);
    environment::ReadEnvironment read = environment::readEnvironment(
        {.source = path.string(), .rotation = 0, .scale = scale, .hasRowsAtPoles = true}, {0, 1, 0},
        report_.isLenient());
    for (const std::string& warning : read.warnings) report_.warn(warning, emitter.place, warning);
    scene_.environment = std::move(read.environment);
  } catch (const FileError& error) {
    report_.deviate(emitter.place, error.what(), "leaves the environment out");
    return;
  }
  const auto axis = [&](const glm::dvec3& local) { return glm::vec3(glm::normalize(turned(map, local))); };
  scene_.environment->axes[0] = axis({0, 0, 1});
  scene_.environment->axes[1] = axis({0, 1, 0});
  scene_.environment->axes[2] = axis({-1, 0, 0});
  scene_.hash = environment::hashOf(*scene_.environment, scene_.hash);
}

}  // namespace candela::mitsuba

// Decides whether a file has light, and adds the default light.
#include "host/formats/loading/default_light.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "host/formats/loading/framing.h"
#include "host/scene/emission_mean.h"

namespace candela::scene {
namespace {

/// Both together show a white surface that faces the light as 0.25 + 2.25 / pi, just below 1.
constexpr float kBackground = 0.25f;
constexpr float kIrradiance = 2.25f;

/// Emission below this mean radiance would leave most of the model black in an 8-bit picture: lamps of vehicles and
/// screens of devices have 0.002 to 0.01, and a room that is lit by a lamp 0.1. 0.02 is displayed as 39 of 255.
constexpr double kFaintRadiance = 0.02;

double areaOf(const Triangle& triangle) {
  const glm::dvec3 a(triangle.p[0]);
  return glm::length(glm::cross(glm::dvec3(triangle.p[1]) - a, glm::dvec3(triangle.p[2]) - a)) / 2;
}

/// Unlit materials, whose emission stands for their colour, do not count.
bool countsAsLight(const Material& material) { return isEmissive(material) && !material.coloursScaleEmission; }

/// Emission that a texture shapes is often decoration, as of labels, displays and headlights, so that a fifth of it
/// counts. Khronos' models with emissive textures then have at most 0.009. A room of 4 x 4 x 3 m has 0.023, if a lamp
/// of one square metre with a radiance of 15 lights it.
constexpr double kTexturedWeight = 0.2;

double weightOf(const Material& material) { return textureOf(material, TextureSlot::emission) ? kTexturedWeight : 1; }

/// The brightest channel, with a texture that of its mean over the triangle, times opacity, area and weight, over all
/// triangles that count as light.
double emissionOf(const Scene& scene) {
  double sum = 0;
  for (const PrimitiveRun& run : scene.primitives.runs()) {
    const Material& material = scene.materials[run.start.material];
    if (!countsAsLight(material)) continue;
    const double factor = weightOf(material) * (material.opacity ? material.opacity->factor : 1);
    const std::uint32_t end = run.first + scene.primitives.countOf(run);
    for (std::uint32_t i = run.first; i < end; ++i) {
      const glm::dvec3 emission = factor * glm::dvec3(material.emission) * meanEmissionTexel(scene, run.at(i));
      sum += std::max({emission.x, emission.y, emission.z}) * areaOf(triangleOf(scene, run.at(i)));
    }
  }
  return sum;
}

/// The radiance of a white sphere around the model that receives all of its emission: the emitted power is pi times
/// emissionOf(), one side of each triangle taken, and a white surface has the radiance irradiance / pi.
double meanRadiance(const Scene& scene, const std::optional<Bounds>& bounds) {
  if (!bounds) return 0;
  const double radius = radiusOf(*bounds);
  const double emission = emissionOf(scene);
  return emission > 0 ? emission / (4 * std::numbers::pi * radius * radius) : 0;
}

bool isGlass(const Material& material) {
  return transmits(material) && !(material.surface && material.surface->metalness == 1);
}

PunctualLight lightBeside(const Camera& camera) {
  const auto& [right, up, forward] = axesOf(camera);
  PunctualLight light;
  light.kind = PunctualLight::Kind::directional;
  light.direction = glm::vec3(glm::normalize(2.0 * forward + right - up));
  light.intensity = glm::vec3(kIrradiance);
  return light;
}

}  // namespace

DefaultLight defaultLightOf(const Scene& scene, const std::optional<Bounds>& bounds) {
  const double radiance = meanRadiance(scene, bounds);
  if (!scene.punctualLights.empty() || radiance >= kFaintRadiance) return {{}, "as in the file"};
  return {lightBeside(*scene.camera), radiance > 0 ? "too faint in the file" : "none in the file"};
}

std::string lightUp(Scene& scene, const DefaultLight& light, const LoadOptions& options) {
  if (!light.light || options.hasEnvironment()) return light.ownLight;
  scene.background = glm::vec3(kBackground);
  scene.punctualLights.push_back(*light.light);
  return fmt::format("{}: a background of {} and a directional light of {} from the camera's upper left",
                     light.ownLight, kBackground, kIrradiance);
}

void setReach(const std::optional<Bounds>& bounds, Scene& scene) {
  if (!bounds) return;
  for (PunctualLight& light : scene.punctualLights) light.reach = static_cast<float>(radiusOf(*bounds));
}

void warnOfShadows(const Scene& scene, DiagnosticLog& log) {
  const auto shows = [&](const PrimitiveRun& run) { return isGlass(scene.materials[run.start.material]); };
  if (scene.punctualLights.empty() || std::ranges::none_of(scene.primitives.runs(), shows)) return;
  log.warn("shadows", {},
           "transmitting surfaces cast shadows of point, spot and directional lights: their light does not pass glass; "
           "that of environments and of emissive surfaces does");
}

}  // namespace candela::scene

// Decides whether a file has light, and adds the default light.
#include "host/formats/gltf/default_light.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "host/scene/emission_mean.h"

namespace candela::gltf {
namespace {

/// Both together show a white surface that faces the light as 0.25 + 2.25 / pi, just below 1.
constexpr float kBackground = 0.25f;
constexpr float kIrradiance = 2.25f;

/// Emission below this mean radiance would leave most of the model black in an 8-bit picture: lamps of vehicles and
/// screens of devices have 0.002 to 0.01, and a room that is lit by a lamp 0.1. 0.02 is displayed as 39 of 255.
constexpr double kFaintRadiance = 0.02;

double areaOf(const scene::Triangle& triangle) {
  const glm::dvec3 a(triangle.p[0]);
  return glm::length(glm::cross(glm::dvec3(triangle.p[1]) - a, glm::dvec3(triangle.p[2]) - a)) / 2;
}

/// Unlit materials, whose emission stands for their colour, do not count.
bool countsAsLight(const scene::Material& material) { return isEmissive(material) && !material.coloursScaleEmission; }

/// Emission that a texture shapes is often decoration, as of labels, displays and headlights, so that a fifth of it
/// counts. Khronos' models with emissive textures then have at most 0.009. A room of 4 x 4 x 3 m has 0.023, if a lamp
/// of one square metre with a radiance of 15 lights it.
constexpr double kTexturedWeight = 0.2;

double weightOf(const scene::Material& material) {
  return textureOf(material, scene::TextureSlot::emission) ? kTexturedWeight : 1;
}

/// The brightest channel, with a texture that of its mean over the triangle, times opacity, area and weight, over all
/// triangles that count as light.
double emissionOf(const scene::Scene& scene) {
  double sum = 0;
  for (const scene::PrimitiveRun& run : scene.primitives.runs()) {
    const scene::Material& material = scene.materials[run.start.material];
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
double meanRadiance(const scene::Scene& scene, const std::optional<Box>& bounds) {
  if (!bounds) return 0;
  const double radius = glm::length(bounds->max - bounds->min) / 2;
  const double emission = emissionOf(scene);
  return emission > 0 ? emission / (4 * std::numbers::pi * radius * radius) : 0;
}

bool transmits(const scene::Scene& scene, const scene::PrimitiveRun& run) {
  const auto& surface = scene.materials[run.start.material].surface;
  return surface && surface->transmissionWeight > 0 && surface->metalness < 1;
}

scene::PunctualLight lightBeside(const scene::Camera& camera) {
  const auto& [right, up, forward] = axesOf(camera);
  scene::PunctualLight light;
  light.kind = scene::PunctualLight::Kind::directional;
  light.direction = glm::vec3(glm::normalize(2.0 * forward + right - up));
  light.intensity = glm::vec3(kIrradiance);
  return light;
}

}  // namespace

DefaultLight defaultLightOf(const scene::Scene& scene, const std::optional<Box>& bounds) {
  const double radiance = meanRadiance(scene, bounds);
  if (!scene.punctualLights.empty() || radiance >= kFaintRadiance) return {{}, "as in the file"};
  return {lightBeside(*scene.camera), radiance > 0 ? "too faint in the file" : "none in the file"};
}

std::string lightUp(scene::Scene& scene, const DefaultLight& light, const scene::LoadOptions& options) {
  if (!light.light || options.hasEnvironment()) return light.ownLight;
  scene.background = glm::vec3(kBackground);
  scene.punctualLights.push_back(*light.light);
  return fmt::format("{}: a background of {} and a directional light of {} from the camera's upper left",
                     light.ownLight, kBackground, kIrradiance);
}

void warnOfShadows(const scene::Scene& scene, scene::DiagnosticLog& log) {
  const auto isGlass = [&](const scene::PrimitiveRun& run) { return transmits(scene, run); };
  if (scene.punctualLights.empty() || std::ranges::none_of(scene.primitives.runs(), isGlass)) return;
  log.warn("shadows", {},
           "transmitting surfaces cast shadows of point, spot and directional lights: their light does not pass glass; "
           "that of environments and of emissive surfaces does");
}

}  // namespace candela::gltf

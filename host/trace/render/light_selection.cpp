// Counts the lights of a scene, and compares their spread with their distance.
#include "host/trace/render/light_selection.h"

#include <algorithm>

#include "host/scene/bounds.h"

namespace candela::render {
namespace {

// The spread of the lights and of what they light, relative to the distance between them, below which a tree does not
// help: the squares of the distances then differ by a factor of less than (1.1 / 0.9)^2 = 1.5.
constexpr float kFarSpread = 0.1f;

bool hasPlace(const scene::PunctualLight& light) { return light.kind != scene::PunctualLight::Kind::directional; }

bool isEmitter(const scene::Scene& scene, const scene::PrimitiveRun& run) {
  const bool isChosen = run.start.kind == scene::PrimitiveKind::triangle ||
                        run.start.kind == scene::PrimitiveKind::sphere;
  return isChosen && isEmissive(scene.materials[run.start.material]);
}

std::size_t countLights(const scene::Scene& scene) {
  auto count = static_cast<std::size_t>(std::ranges::count_if(scene.punctualLights, hasPlace));
  for (const scene::PrimitiveRun& run : scene.primitives.runs()) {
    if (isEmitter(scene, run)) count += scene.primitives.countOf(run);
  }
  return count;
}

bool areFar(const scene::Scene& scene) {
  if (std::ranges::any_of(scene.punctualLights, hasPlace)) return false;
  const auto lights = boundsOf(scene, [&](const scene::PrimitiveRun& run) { return isEmitter(scene, run); });
  const auto lit = boundsOf(scene, [&](const scene::PrimitiveRun& run) { return !isEmitter(scene, run); });
  if (!lights || !lit) return false;
  const glm::vec3 between = (lights->min + lights->max) / 2.0f - (lit->min + lit->max) / 2.0f;
  const float spread = glm::length(lights->max - lights->min) / 2 + glm::length(lit->max - lit->min) / 2;
  return spread < kFarSpread * glm::length(between);
}

}  // namespace

LightSelection selectionFor(const scene::Scene& scene) {
  if (countLights(scene) < kMinTreeLights || areFar(scene)) return LightSelection::power;
  return LightSelection::tree;
}

}  // namespace candela::render

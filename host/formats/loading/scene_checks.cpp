// Checks that need the complete scene.
#include "host/formats/loading/scene_checks.h"

#include <algorithm>

namespace candela::scene {

bool hasLight(const Scene& scene) {
  if (scene.sky || scene.background != glm::vec3(0)) return true;
  const auto shines = [](const PointLight& light) { return light.colour != glm::vec3(0); };
  if (std::ranges::any_of(scene.pointLights, shines)) return true;
  const auto isBright = [](const PunctualLight& light) { return light.intensity != glm::vec3(0); };
  if (std::ranges::any_of(scene.punctualLights, isBright)) return true;
  const auto emits = [&](const PrimitiveRun& run) { return isEmissive(scene.materials[run.start.material]); };
  return std::ranges::any_of(scene.primitives.runs(), emits);
}

void checkScene(const Scene& scene, const LoadOptions& options, DiagnosticLog& log) {
  if (scene.primitives.empty()) log.warn("no objects", {}, "the scene has no objects");
  if (options.hasEnvironment() || hasLight(scene)) return;
  log.warn("no light", {},
           "the image will be black: no object emits, there is no point light, and the background is black");
}

}  // namespace candela::scene

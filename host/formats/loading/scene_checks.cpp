// Checks that need the complete scene.
#include "host/formats/loading/scene_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/formats/loading/framing.h"

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

// Vertices are rounded to single precision, whose resolution falls with the distance from the origin.
void warnOfExtent(const std::optional<Bounds>& bounds, DiagnosticLog& log) {
  constexpr double kMinSteps = 4096;  // along the diagonal of the model
  if (!bounds) return;
  if (!hasExtent(*bounds)) {
    log.warn("extent", {}, "the model has no extent: all of its vertices are at one point, as with a scale of 0");
    return;
  }
  double largest = 0;
  for (int axis = 0; axis < 3; ++axis)
    largest = std::max({largest, std::abs(double{bounds->min[axis]}), std::abs(double{bounds->max[axis]})});
  const double step = std::ldexp(1.0, std::ilogb(largest) - 23);
  const double steps = 2 * radiusOf(*bounds) / step;
  if (steps >= kMinSteps) return;
  log.warn("extent", {},
           fmt::format("the model is so far from the origin that single precision resolves only 1/{:.0f} of its size "
                       "({:.2g} units at a distance of {:.2g}); move it, its camera and its lights to the origin",
                       steps, step, largest));
}

void checkScene(const Scene& scene, const LoadOptions& options, DiagnosticLog& log) {
  if (scene.primitives.empty()) log.warn("no objects", {}, "the scene has no objects");
  if (options.hasEnvironment() || hasLight(scene)) return;
  log.warn("no light", {},
           "the image will be black: no object emits, there is no point light, and the background is black");
}

}  // namespace candela::scene

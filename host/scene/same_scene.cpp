// Compares all members of scenes but those that a view changes.
#include "host/scene/same_scene.h"

#include <tuple>

namespace candela::scene {
namespace {

/// The binding names every member of a scene, so that a new one is not forgotten: it does not compile without it.
auto contentOf(const Scene& scene) {
  const auto& [name, camera, background, sky, environment, up, materials, images, primitives, spheres, meshes,
               placements, boxes, cones, planes, objectStarts, objectNames, materialNames, pointLights, punctualLights,
               requestedAccel, requestedSamples, requestedMaxDepth, requestedFilter, requestedCrop, exactMean,
               hash] = scene;
  return std::tie(background, sky, environment, up, materials, images, primitives, spheres, meshes, placements, boxes,
                  cones, planes, objectStarts, objectNames, materialNames, pointLights, punctualLights, requestedAccel,
                  requestedSamples, requestedMaxDepth, requestedFilter, requestedCrop, exactMean);
}

}  // namespace

bool differOnlyInCamera(const Scene& a, const Scene& b) { return contentOf(a) == contentOf(b); }

}  // namespace candela::scene

// Determines the features that a scene uses.
#include "host/flatten/flatten_features.h"

#include <vector>

#include "host/flatten/lobes.h"

namespace candela::flatten {
namespace {

void noteKind(const scene::Scene& scene, const scene::Primitive& primitive, SceneFeatures& features) {
  switch (primitive.kind) {
    case scene::PrimitiveKind::sphere:
      features.spheres = true;
      features.insideOnly |= scene.spheres[primitive.index].radius < 0;
      break;
    case scene::PrimitiveKind::triangle:
      features.triangles = true;
      features.smooth |= scene.triangles[primitive.index].normals != scene::Triangle::kNoNormals;
      break;
    case scene::PrimitiveKind::box:
      features.boxes = true;
      break;
    case scene::PrimitiveKind::cone:
      features.cones = true;
      break;
    case scene::PrimitiveKind::plane:
      features.planes = true;
      break;
  }
}

void noteMaterial(const scene::Material& material, render::Integrator integrator, SceneFeatures& features) {
  const Lobes lobes = lobesFor(integrator, material);
  features.diffuse |= lobes.diffuse > 0;
  features.glossy |= lobes.glossy > 0;
  features.dielectric |= lobes.dielectric > 0;
  features.mirror |= lobes.mirror;
  features.mixtures |= (lobes.diffuse > 0) + (lobes.glossy > 0) + (lobes.dielectric > 0) > 1;
  features.emission |= ownRadiance(integrator, material) != glm::dvec3(0);
}

}  // namespace

SceneFeatures featuresOf(const scene::Scene& scene, render::Integrator integrator) {
  SceneFeatures features;
  std::vector<bool> used(scene.materials.size());
  for (const scene::Primitive& primitive : scene.primitives) {
    noteKind(scene, primitive, features);
    used[primitive.material] = true;
  }
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (used[i]) noteMaterial(scene.materials[i], integrator, features);
  }
  features.sky = scene.sky.has_value();
  return features;
}

}  // namespace candela::flatten

// Counts the content of a scene.
#include "host/formats/scene_report.h"

#include <algorithm>

#include "host/scene/bounds.h"
#include "host/scene/film_scale.h"
#include "host/scene/shape.h"

namespace candela::scene {
namespace {

struct EmitterCount {
  SceneReport::Lights& lights;

  void operator()(const Sphere&) const { ++lights.spheres; }
  void operator()(const Triangle&) const { ++lights.triangles; }
  void operator()(const Cone&) const { ++lights.cones; }
  void operator()(const Plane&) const { ++lights.planes; }
  void operator()(const Box&) const {}  // emitting boxes have become triangles
};

SceneReport::Lights lightsOf(const Scene& scene) {
  SceneReport::Lights lights;
  lights.points = scene.pointLights.size();
  for (const PunctualLight& light : scene.punctualLights) {
    if (light.kind == PunctualLight::Kind::point) ++lights.points;
    if (light.kind == PunctualLight::Kind::spot) ++lights.spots;
    if (light.kind == PunctualLight::Kind::directional) ++lights.directionals;
  }
  for (const Primitive& primitive : scene.primitives) {
    if (!isEmissive(scene.materials[primitive.material])) continue;
    std::visit(EmitterCount{lights}, shapeOf(scene, primitive));
  }
  return lights;
}

SceneReport::Materials materialsOf(const Scene& scene) {
  SceneReport::Materials materials;
  for (const Material& m : scene.materials) {
    if (isEmissive(m)) ++materials.emitting;
    switch (kindOf(m)) {
      case MaterialKind::black:
        ++materials.black;
        break;
      case MaterialKind::diffuse:
        ++materials.diffuse;
        break;
      case MaterialKind::glossy:
        ++materials.glossy;
        break;
      case MaterialKind::dielectric:
        ++materials.dielectric;
        break;
      case MaterialKind::mirror:
        ++materials.mirror;
        break;
      case MaterialKind::mixture:
        ++materials.mixture;
        break;
      case MaterialKind::surface:
        ++materials.surface;
        break;
    }
  }
  return materials;
}

std::optional<std::uint32_t> skySideOf(const Scene& scene) {
  if (!scene.sky) return std::nullopt;
  std::uint32_t side = 0;
  for (const SkyFace& face : scene.sky->faces) side = std::max({side, face.width, face.height});
  return side;
}

}  // namespace

SceneReport makeReport(const LoadedScene& loaded) {
  const Scene& scene = loaded.scene;
  SceneReport report;
  report.name = scene.name;
  report.statements = loaded.counts;
  report.facts = loaded.facts;
  report.memory = memoryOf(scene);
  report.primitives = {scene.spheres.size(), report.memory.triangleCount, scene.boxes.size(), scene.cones.size(),
                       scene.planes.size()};
  report.bounds = boundsOf(scene);
  report.lights = lightsOf(scene);
  report.materials = materialsOf(scene);
  report.coincident = coincidentObjects(scene);
  report.camera = scene.camera;
  report.background = scene.background;
  report.skySide = skySideOf(scene);
  report.filmScale = filmScaleOf(scene);
  report.requestedAccel = scene.requestedAccel;
  report.requestedSamples = scene.requestedSamples;
  report.hash = scene.hash;
  for (const Diagnostic& warning : loaded.warnings) report.warnings.push_back(toString(warning));
  return report;
}

}  // namespace candela::scene

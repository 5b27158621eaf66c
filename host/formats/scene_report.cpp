// Counts the content of a scene.
#include "host/formats/scene_report.h"

#include <algorithm>

#include "host/scene/bounds.h"
#include "host/scene/film_scale.h"

namespace candela::scene {
namespace {

void countEmitters(PrimitiveKind kind, std::size_t count, SceneReport::Lights& lights) {
  switch (kind) {
    case PrimitiveKind::sphere:
      lights.spheres += count;
      break;
    case PrimitiveKind::triangle:
      lights.triangles += count;
      break;
    case PrimitiveKind::cone:
      lights.cones += count;
      break;
    case PrimitiveKind::plane:
      lights.planes += count;
      break;
    case PrimitiveKind::box:  // emitting boxes have become triangles
      break;
  }
}

SceneReport::Lights lightsOf(const Scene& scene) {
  SceneReport::Lights lights;
  lights.points = scene.pointLights.size();
  for (const PunctualLight& light : scene.punctualLights) {
    if (light.kind == PunctualLight::Kind::point) ++lights.points;
    if (light.kind == PunctualLight::Kind::spot) ++lights.spots;
    if (light.kind == PunctualLight::Kind::directional) ++lights.directionals;
  }
  for (const PrimitiveRun& run : scene.primitives.runs()) {
    if (!isEmissive(scene.materials[run.start.material])) continue;
    countEmitters(run.start.kind, scene.primitives.countOf(run), lights);
  }
  return lights;
}

SceneReport::Materials materialsOf(const Scene& scene) {
  SceneReport::Materials materials;
  for (const Material& m : scene.materials) {
    if (isEmissive(m) && !m.choice) ++materials.emitting;
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
      case MaterialKind::choice:
        break;  // its materials are counted
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
  report.requestedMaxDepth = scene.requestedMaxDepth;
  report.requestedFilter = scene.requestedFilter;
  report.requestedCrop = scene.requestedCrop;
  report.hash = scene.hash;
  for (const Diagnostic& warning : loaded.warnings) report.warnings.push_back(toString(warning));
  return report;
}

}  // namespace candela::scene

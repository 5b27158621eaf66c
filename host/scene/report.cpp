// Counts the content of a scene.
#include "host/scene/report.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/scene/shape.h"

namespace candela::scene {
namespace {

/// A growing box. It is computed in double precision and rounded to nearest at the end.
class Extent3 {
 public:
  void add(const glm::dvec3& centre, const glm::dvec3& halfSize = glm::dvec3(0)) {
    min_ = glm::min(min_, centre - halfSize);
    max_ = glm::max(max_, centre + halfSize);
  }
  std::optional<SceneReport::Bounds> bounds() const {
    if (min_.x > max_.x) return std::nullopt;
    return SceneReport::Bounds{glm::vec3(min_), glm::vec3(max_)};
  }

 private:
  glm::dvec3 min_{std::numeric_limits<double>::infinity()};
  glm::dvec3 max_{-std::numeric_limits<double>::infinity()};
};

/// A circle around a unit axis reaches r sqrt(1 - axis^2) along each coordinate.
void addCone(Extent3& extent, const Cone& cone) {
  const glm::dvec3 base = cone.base;
  const glm::dvec3 apex = cone.apex;
  const glm::dvec3 axis = glm::normalize(apex - base);
  const glm::dvec3 reach = glm::sqrt(glm::max(1.0 - axis * axis, 0.0));
  extent.add(base, static_cast<double>(cone.baseRadius) * reach);
  extent.add(apex, static_cast<double>(cone.apexRadius) * reach);
}

std::optional<SceneReport::Bounds> boundsOf(const Scene& scene) {
  Extent3 extent;
  for (const Sphere& s : scene.spheres) extent.add(s.centre, glm::dvec3(std::abs(static_cast<double>(s.radius))));
  for (const Primitive& primitive : scene.primitives) {
    if (primitive.kind != PrimitiveKind::triangle) continue;
    const Triangle triangle = triangleOf(scene, primitive);
    for (const glm::vec3& vertex : triangle.p) extent.add(vertex);
  }
  for (const Box& box : scene.boxes) {
    extent.add(box.min);
    extent.add(box.max);
  }
  for (const Cone& cone : scene.cones) addCone(extent, cone);
  return extent.bounds();
}

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
  report.camera = scene.camera;
  report.background = scene.background;
  report.skySide = skySideOf(scene);
  report.requestedAccel = scene.requestedAccel;
  report.requestedSamples = scene.requestedSamples;
  report.hash = scene.hash;
  for (const Diagnostic& warning : loaded.warnings) report.warnings.push_back(toString(warning));
  return report;
}

}  // namespace candela::scene

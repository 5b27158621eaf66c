// Scenes for tests, filled in directly.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>

#include "host/formats/loading/scene_builder.h"
#include "host/formats/nff/nff_material.h"
#include "host/scene/scene.h"
#include "host/trace/reference/reference_renderer.h"
#include "host/trace/render/renderer.h"
#include "tests/trace/reference/default_settings.h"

namespace candela::test {

using glm::dvec3;
using glm::vec3;

inline scene::Material diffuseMaterial(const vec3& albedo, const vec3& emission = vec3(0)) {
  return scene::fromNff({.diffuse = albedo, .emission = emission});
}

inline scene::Material mirrorMaterial(const vec3& colour) {
  return scene::fromNff({.diffuse = colour, .kd = 0, .ks = 1});
}

inline scene::Material glassMaterial(const vec3& colour, float ior) {
  return scene::fromNff({.diffuse = colour, .kd = 0, .t = 1, .ior = ior});
}

inline scene::Material mixtureMaterial(float kd, float ks, float shine, float t = 0, float ior = 1) {
  return scene::fromNff({.kd = kd, .ks = ks, .shine = shine, .t = t, .ior = ior});
}

/// Primitives take the material that was added last.
class SceneBuilder {
 public:
  scene::Scene scene;

  SceneBuilder() { scene.camera.emplace(); }

  SceneBuilder& material(const scene::Material& value) {
    scene.materials.push_back(value);
    return *this;
  }
  SceneBuilder& sphere(const vec3& centre, float radius) {
    return add(scene::PrimitiveKind::sphere, scene.spheres, {centre, radius});
  }
  SceneBuilder& triangle(const vec3& a, const vec3& b, const vec3& c) {
    addTriangle(scene, {{a, b, c}}, lastMaterial());
    return *this;
  }
  SceneBuilder& patch(const vec3& a, const vec3& b, const vec3& c, const scene::VertexNormals& normals) {
    addTriangle(scene, {{a, b, c}}, normals, lastMaterial());
    return *this;
  }
  /// Counter-clockwise from its front.
  SceneBuilder& quad(const vec3& a, const vec3& b, const vec3& c, const vec3& d) {
    return triangle(a, b, c).triangle(a, c, d);
  }
  SceneBuilder& box(const vec3& min, const vec3& max) {
    return add(scene::PrimitiveKind::box, scene.boxes, {min, max});
  }
  SceneBuilder& cone(const vec3& base, float baseRadius, const vec3& apex, float apexRadius) {
    return add(scene::PrimitiveKind::cone, scene.cones, {base, baseRadius, apex, apexRadius});
  }
  SceneBuilder& plane(const vec3& a, const vec3& b, const vec3& c) {
    return add(scene::PrimitiveKind::plane, scene.planes, {{a, b, c}});
  }
  SceneBuilder& pointLight(const vec3& position, const vec3& colour) {
    scene.pointLights.push_back({position, colour});
    return *this;
  }
  SceneBuilder& view(const vec3& from, const vec3& at, const vec3& up, float angle) {
    scene.camera->from = from;
    scene.camera->at = at;
    scene.camera->up = up;
    scene.camera->angle = angle;
    return *this;
  }

 private:
  template <class Shape>
  SceneBuilder& add(scene::PrimitiveKind kind, std::vector<Shape>& shapes, const Shape& shape) {
    shapes.push_back(shape);
    scene.primitives.push_back({kind, static_cast<std::uint32_t>(shapes.size() - 1), lastMaterial()});
    return *this;
  }
  std::uint32_t lastMaterial() const { return static_cast<std::uint32_t>(scene.materials.size() - 1); }
};

/// A closed box of side 2 around the origin: red on the left, green on the right, a light below the ceiling; in it a
/// box, a mirror ball and a glass ball. The camera is inside.
inline SceneBuilder cornellBox() {
  SceneBuilder b;
  b.view({0, 0, 0.95f}, {0, 0, 0}, {0, 1, 0}, 80);
  b.material(diffuseMaterial({0.7f, 0.7f, 0.7f}));
  b.quad({-1, -1, 1}, {1, -1, 1}, {1, -1, -1}, {-1, -1, -1});
  b.quad({-1, 1, -1}, {1, 1, -1}, {1, 1, 1}, {-1, 1, 1});
  b.quad({-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1});
  b.quad({-1, 1, 1}, {1, 1, 1}, {1, -1, 1}, {-1, -1, 1});
  b.material(diffuseMaterial({0.7f, 0.1f, 0.1f})).quad({-1, -1, 1}, {-1, -1, -1}, {-1, 1, -1}, {-1, 1, 1});
  b.material(diffuseMaterial({0.1f, 0.7f, 0.1f})).quad({1, -1, -1}, {1, -1, 1}, {1, 1, 1}, {1, 1, -1});
  b.material(diffuseMaterial(vec3(0), vec3(8)));
  b.quad({-0.3f, 0.99f, -0.3f}, {0.3f, 0.99f, -0.3f}, {0.3f, 0.99f, 0.3f}, {-0.3f, 0.99f, 0.3f});
  b.material(mixtureMaterial(0.4f, 0.4f, 40)).box({-0.2f, -1, -0.8f}, {0.2f, -0.5f, -0.4f});
  b.material(mirrorMaterial(vec3(0.9f))).sphere({-0.5f, -0.7f, -0.3f}, 0.3f);
  b.material(glassMaterial(vec3(0.9f), 1.5f)).sphere({0.5f, -0.7f, 0}, 0.3f);
  return b;
}

inline render::RenderSettings settingsOf(std::uint32_t width, std::uint32_t height, std::uint32_t sampleCount) {
  render::RenderSettings settings = render::defaultSettings();
  settings.image.size = {width, height};
  settings.image.sampleCount = sampleCount;
  return settings;
}

inline render::RenderResult renderScene(const scene::Scene& scene, const render::RenderSettings& settings) {
  return reference::makeReferenceRenderer()->render(scene, settings, {});
}

/// Mean of all pixels.
inline dvec3 meanOf(const image::Film& film) {
  dvec3 sum(0);
  for (std::uint32_t y = 0; y < film.height(); ++y) {
    for (std::uint32_t x = 0; x < film.width(); ++x) sum += film.mean(x, y);
  }
  return sum / (double{1} * film.width() * film.height());
}

}  // namespace candela::test

// Traces of paths with chosen values.
#pragma once
#include "host/formats/nff/nff_material.h"
#include "host/judge/explain/explanation.h"
#include "tests/trace/reference/default_settings.h"

namespace candela::explain {

/// Two spheres, the second of which is a light; a diffuse material and one that emits.
inline scene::Scene twoSpheres() {
  scene::Scene scene;
  scene.name = "made.p3f";
  scene.materials = {scene::fromNff({}), scene::fromNff({.emission = glm::vec3(5)})};
  scene.spheres = {{glm::vec3(0), 1}, {glm::vec3(0, 0, 9), 1}};
  scene.primitives = {{scene::PrimitiveKind::sphere, 0, 0}, {scene::PrimitiveKind::sphere, 1, 1}};
  return scene;
}

/// A path that hits the first sphere, is lit by the light, and then hits nothing.
inline render::PathTrace madePath() {
  render::VertexTrace first;
  first.origin = {0, -5, 0};
  first.direction = {0, 1, 0};
  first.numbers = {0x10000000u, 0x20000000u, 0x30000000u, 0x40000000u, 0x50000000u, 0x60000000u, 0x70000000u};
  first.hit = render::HitTrace{.primitive = 0,
                               .material = 0,
                               .distance = 4,
                               .position = {0, -1, 0},
                               .normal = {0, -1, 0},
                               .shadingNormal = {0, -1, 0}};
  first.light = render::LightTrace{.entry = 0,
                                   .primitive = 1,
                                   .shadow = render::ShadowOutcome::visible,
                                   .direction = {0, 0, 1},
                                   .distance = 8,
                                   .pdf = 2,
                                   .bsdfPdf = 0.25,
                                   .weight = 0.75,
                                   .radiance = {0.5, 0.5, 0.5}};
  first.scattering = render::ScatteringTrace{render::Lobe::diffuse, {0, -1, 0}, 0.3, {0.8, 0.8, 0.8}};
  first.roulette = render::RouletteTrace{0.8, true};
  first.radiance = {0.5, 0.5, 0.5};
  render::VertexTrace last;
  last.origin = {0, -1, 0};
  last.direction = {0, -1, 0};
  last.radiance = {0.6, 0.6, 0.6};
  render::PathTrace path;
  path.vertices = {first, last};
  path.vertexCount = 2;
  path.radiance = last.radiance;
  return path;
}

inline Explanation explainMade(const render::PathTrace& device, const render::PathTrace& reference) {
  render::Replay a{device, {}};
  a.statistics.device = "a device";
  return explainReplays(twoSpheres(), render::defaultSettings(), {3, 4, 5}, a, {reference, {}});
}

}  // namespace candela::explain

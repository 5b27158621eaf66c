// Scenes with many lights of all kinds that a light tree can have.
#pragma once
#include <cmath>
#include <cstdint>

#include "host/base/hash.h"
#include "tests/trace/reference/placed_meshes.h"
#include "tests/trace/reference/scene_builder.h"

namespace candela::test {

/// Deterministic numbers in [0, 1), in the order of the calls.
class LampNumbers {
 public:
  explicit LampNumbers(std::uint64_t seed) : state_(splitMix(seed)) {}
  float next() { return static_cast<float>(splitMix(state_ += kSplitMixStep) >> 40) * 0x1p-24f; }
  glm::vec3 inCube(float side) {
    const float x = next(), y = next(), z = next();
    return side * (glm::vec3(x, y, z) - 0.5f);
  }

 private:
  std::uint64_t state_;
};

/// `count` triangles, spheres, point and spot lights in turns, in a cube of 20 units, whose powers differ by a factor
/// of up to 10^4. Lights of power 0 and directional lights are among them.
inline scene::Scene mixedLamps(std::uint32_t count, std::uint64_t seed) {
  SceneBuilder b;
  LampNumbers numbers(seed);
  for (std::uint32_t i = 0; i < count; ++i) {
    const glm::vec3 place = numbers.inCube(20);
    const glm::vec3 colour(i % 17 == 5 ? 0.0f : std::pow(10.0f, 4 * numbers.next() - 2));
    if (i % 4 < 2) {
      b.material(diffuseMaterial(glm::vec3(0.5f), colour));
      const float size = 0.02f + numbers.next();
      if (i % 4 == 0)
        b.sphere(place, size / 2);
      else
        b.triangle(place, place + numbers.inCube(size), place + numbers.inCube(size));
      continue;
    }
    scene::PunctualLight light{.position = place, .intensity = colour};
    if (i % 4 == 3) {
      light.kind = i % 31 == 7 ? scene::PunctualLight::Kind::directional : scene::PunctualLight::Kind::spot;
      light.direction = glm::normalize(numbers.inCube(1));
      light.versineOuter = 0.05f + 1.5f * numbers.next();
      light.versineInner = light.versineOuter / 2;
    }
    b.scene.punctualLights.push_back(light);
  }
  return b.scene;
}

/// A ball of radius 1 with 80 triangles, some of which have no area, whose sizes and shapes differ.
inline scene::Mesh unevenBall() {
  constexpr std::uint32_t kRings = 5, kParts = 8;
  scene::Mesh mesh;
  for (std::uint32_t ring = 0; ring <= kRings; ++ring) {
    const float polar = 3.14159265f * std::pow(static_cast<float>(ring) / kRings, 1.5f);
    const float radius = ring == kRings ? 0 : std::sin(polar);
    for (std::uint32_t part = 0; part < kParts; ++part) {
      const float azimuth = 6.2831853f * static_cast<float>(part) / kParts;
      mesh.positions.emplace_back(radius * std::cos(azimuth), radius * std::sin(azimuth), std::cos(polar));
      if (ring == kRings) continue;
      const std::uint32_t at = ring * kParts + part, next = ring * kParts + (part + 1) % kParts;
      mesh.indices.insert(mesh.indices.end(), {at, at + kParts, next + kParts, at, next + kParts, next});
    }
  }
  return mesh;
}

/// mixedLamps() and `instances` instances of one mesh, the emission of which has one of two materials, at placements
/// that turn, shear, mirror and scale.
inline scene::Scene lampsAndInstances(std::uint32_t count, std::uint32_t instances, std::uint64_t seed) {
  SceneBuilder b;
  b.scene = mixedLamps(count, seed);
  RandomMaps maps(static_cast<std::uint32_t>(seed));
  const std::uint32_t stored = storeBoth(b.scene, unevenBall());
  const auto first = static_cast<std::uint32_t>(b.scene.materials.size());
  b.material(diffuseMaterial(glm::vec3(0.5f), glm::vec3(4, 2, 1)));
  b.material(diffuseMaterial(glm::vec3(0.5f), glm::vec3(0.1f, 0.2f, 0.3f)));
  for (std::uint32_t i = 0; i < instances; ++i) {
    addInstance(b.scene, maps.next(maps.number(0.05, 1), maps.point(9)), stored, first + i % 2);
  }
  return b.scene;
}

/// The lamps of lampsAndInstances() in a closed room of 24 units, seen from a corner: its walls are diffuse and, in
/// part, glossy, and a pane of rough glass divides it.
inline scene::Scene litRoom(std::uint32_t count, std::uint64_t seed, std::uint32_t instances = 0) {
  SceneBuilder b;
  b.scene = lampsAndInstances(count, instances, seed);
  b.material(mixtureMaterial(0.5f, 0.2f, 20)).box({-12, -12, -12}, {12, 12, 12});
  scene::Material pane;
  pane.surface = scene::SurfaceParameters{.roughness = 0.4f, .transmissionWeight = 0.7f};
  b.material(pane);
  b.quad({-6, -6, 1}, {6, -6, 1}, {6, 6, 1}, {-6, 6, 1});
  b.view({11, 9, 10}, {-2, -1, -1}, {0, 0, 1}, 60);
  return b.scene;
}

}  // namespace candela::test

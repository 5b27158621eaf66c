// The lights of generated scenes, and what is in front of them.
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "host/scene/scene.h"

namespace candela {

/// A sphere or triangle that emits light.
struct Emitter {
  std::uint32_t primitive;  ///< index in Scene::primitives
  bool isSphere;
  glm::dvec3 centre;
  glm::dvec3 normal;  ///< of a triangle's front, unit
  double area;
  glm::dvec3 radiance;

  /// The mean of its channels, of a triangle on both sides.
  double power() const;
};

std::vector<Emitter> emittersOf(const scene::Scene& scene);

/// Returns the points of an emitter from which its light should reach what is in front of it, 0.1 mm before it.
std::vector<glm::dvec3> pointsBefore(const scene::Scene& scene, const Emitter& emitter);

/// Returns whether a box, a triangle or a sphere has a point of the segment from `a` to `b`. Surfaces count, and the
/// inside of boxes and spheres does, too. Emitters do not.
bool isObstructed(const scene::Scene& scene, const glm::dvec3& a, const glm::dvec3& b);

/// Returns the number of primitives that coincide with others: host/scene/coincidence.
std::size_t coincidentCount(const scene::Scene& scene);

}  // namespace candela

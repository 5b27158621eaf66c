// Adds primitives to a scene, in order.
#pragma once
#include <cstdint>
#include <span>

#include "host/scene/scene.h"

namespace candela::scene {

/// Each appends one primitive with the given material (an index into Scene::materials).
void addSphere(Scene& scene, const Sphere& sphere, std::uint32_t material);
void addTriangle(Scene& scene, const Triangle& triangle, std::uint32_t material);
void addBox(Scene& scene, const Box& box, std::uint32_t material);
void addCone(Scene& scene, const Cone& cone, std::uint32_t material);
void addPlane(Scene& scene, const Plane& plane, std::uint32_t material);

/// Appends the faces of a box, seen from outside, as triangles: 12, or 2 if the box is flat on one axis (of faces that
/// coincide only one may shine), or none if it has no area.
void addBoxAsTriangles(Scene& scene, const Box& box, std::uint32_t material);

/// Appends the parallelogram corner, corner + u, corner + u + v, corner + v as two triangles with normal u x v.
void addParallelogram(Scene& scene, const glm::vec3& corner, const glm::vec3& u, const glm::vec3& v,
                      std::uint32_t material);

}  // namespace candela::scene

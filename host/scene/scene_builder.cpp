// Adds primitives to a scene.
#include "host/scene/scene_builder.h"

namespace candela::scene {
namespace {

template <typename Shape>
void add(Scene& scene, std::vector<Shape>& shapes, const Shape& shape, PrimitiveKind kind, std::uint32_t material) {
  scene.primitives.push_back({kind, static_cast<std::uint32_t>(shapes.size()), material});
  shapes.push_back(shape);
}

void addQuad(Scene& scene, const glm::vec3 (&corner)[4], std::uint32_t material) {
  addTriangle(scene, {{corner[0], corner[1], corner[2]}}, material);
  addTriangle(scene, {{corner[0], corner[2], corner[3]}}, material);
}

/// Returns the face of `box` at the minimum or maximum of `axis`, counter-clockwise seen from outside.
void addFace(Scene& scene, const Box& box, int axis, bool atMax, std::uint32_t material) {
  const int first = (axis + (atMax ? 1 : 2)) % 3;
  const int second = (axis + (atMax ? 2 : 1)) % 3;
  glm::vec3 corner[4];
  for (glm::vec3& c : corner) {
    c = box.min;
    c[axis] = atMax ? box.max[axis] : box.min[axis];
  }
  corner[1][first] = corner[2][first] = box.max[first];
  corner[2][second] = corner[3][second] = box.max[second];
  addQuad(scene, corner, material);
}

}  // namespace

void addSphere(Scene& scene, const Sphere& sphere, std::uint32_t material) {
  add(scene, scene.spheres, sphere, PrimitiveKind::sphere, material);
}
void addTriangle(Scene& scene, const Triangle& triangle, std::uint32_t material) {
  add(scene, scene.triangles, triangle, PrimitiveKind::triangle, material);
}
void addBox(Scene& scene, const Box& box, std::uint32_t material) {
  add(scene, scene.boxes, box, PrimitiveKind::box, material);
}
void addCone(Scene& scene, const Cone& cone, std::uint32_t material) {
  add(scene, scene.cones, cone, PrimitiveKind::cone, material);
}
void addPlane(Scene& scene, const Plane& plane, std::uint32_t material) {
  add(scene, scene.planes, plane, PrimitiveKind::plane, material);
}

void addBoxAsTriangles(Scene& scene, const Box& box, std::uint32_t material) {
  const glm::vec3 extent = box.max - box.min;
  for (int axis = 0; axis < 3; ++axis) {
    const bool hasArea = extent[(axis + 1) % 3] > 0 && extent[(axis + 2) % 3] > 0;
    if (!hasArea) continue;
    addFace(scene, box, axis, true, material);
    if (extent[axis] > 0) addFace(scene, box, axis, false, material);
  }
}

void addParallelogram(Scene& scene, const glm::vec3& corner, const glm::vec3& u, const glm::vec3& v,
                      std::uint32_t material) {
  addQuad(scene, {corner, corner + u, corner + u + v, corner + v}, material);
}

}  // namespace candela::scene

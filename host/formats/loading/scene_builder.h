// Adds primitives to a scene.
#pragma once
#include <cstdint>
#include <span>

#include "host/scene/scene.h"

namespace candela::scene {

/// Each function appends one primitive with the given material (an index into Scene::materials).
void addSphere(Scene& scene, const Sphere& sphere, std::uint32_t material);
/// Appends its vertices to the scene's mesh without indices, which contains all such triangles.
void addTriangle(Scene& scene, const Triangle& triangle, std::uint32_t material);
/// Appends a triangle with vertex normals, to another mesh.
void addTriangle(Scene& scene, const Triangle& triangle, const VertexNormals& normals, std::uint32_t material);
void addBox(Scene& scene, const Box& box, std::uint32_t material);
void addCone(Scene& scene, const Cone& cone, std::uint32_t material);
void addPlane(Scene& scene, const Plane& plane, std::uint32_t material);

/// Appends the triangles of a mesh, each as one primitive, and the mesh itself. A mesh without triangles is left out.
/// Throws FileError beyond Primitive::kMaxMeshes meshes.
void addMesh(Scene& scene, Mesh mesh, std::uint32_t material);

/// Adds a mesh without any primitive, and returns its index. Throws FileError like addMesh().
std::uint32_t storeMesh(Scene& scene, Mesh mesh);

/// Appends the triangles of an instance of a mesh of the scene, each as one primitive, with their placement.
void addInstance(Scene& scene, std::uint32_t mesh, const Placement& placement, std::uint32_t material);

/// Appends triangles over vertices that they share: three indices into `positions` each. All such triangles share one
/// mesh, so that many small meshes take no more memory than a large one.
void addIndexedTriangles(Scene& scene, std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                         std::uint32_t material);

/// Appends the faces of a box, with their fronts outside, as triangles: 12; or 2 if the box is flat along one axis,
/// since only one of two coincident faces may emit; or none if it has no area.
void addBoxAsTriangles(Scene& scene, const Box& box, std::uint32_t material);

/// Appends the parallelogram corner, corner + u, corner + u + v, corner + v as two triangles with normal u x v.
void addParallelogram(Scene& scene, const glm::vec3& corner, const glm::vec3& u, const glm::vec3& v,
                      std::uint32_t material);

}  // namespace candela::scene

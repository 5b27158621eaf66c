// Adds primitives to a scene.
#include "host/formats/loading/scene_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "host/base/errors.h"

namespace candela::scene {
namespace {

template <typename Shape>
void add(Scene& scene, std::vector<Shape>& shapes, const Shape& shape, PrimitiveKind kind, std::uint32_t material) {
  scene.primitives.push_back({kind, static_cast<std::uint32_t>(shapes.size()), material});
  shapes.push_back(shape);
}

/// Returns the index of the first mesh with or without indices and normals, and with no other attribute than positions.
std::uint32_t findOrAddMesh(Scene& scene, bool hasIndices, bool hasNormals) {
  const auto fits = [&](const Mesh& mesh) {
    const bool isPlain = mesh.texCoords[0].empty() && mesh.texCoords[1].empty() && mesh.tangents.empty() &&
                         mesh.colours.empty();
    return isPlain && mesh.indices.empty() != hasIndices && mesh.normals.empty() != hasNormals;
  };
  const auto found = std::ranges::find_if(scene.meshes, fits);
  const auto index = static_cast<std::uint32_t>(found - scene.meshes.begin());
  if (found == scene.meshes.end()) storeMesh(scene, {});
  return index;
}

/// Adds a primitive for each triangle of a mesh from `first` on.
void addTrianglesOf(Scene& scene, std::uint32_t mesh, std::size_t first, std::uint32_t material) {
  const std::size_t count = triangleCount(scene.meshes[mesh]) - first;
  scene.primitives.append({PrimitiveKind::triangle, static_cast<std::uint32_t>(first), material, mesh},
                          static_cast<std::uint32_t>(count));
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
  const std::uint32_t index = findOrAddMesh(scene, false, false);
  Mesh& mesh = scene.meshes[index];
  mesh.positions.insert(mesh.positions.end(), std::begin(triangle.p), std::end(triangle.p));
  addTrianglesOf(scene, index, triangleCount(mesh) - 1, material);
}
void addTriangle(Scene& scene, const Triangle& triangle, const VertexNormals& normals, std::uint32_t material) {
  const std::uint32_t index = findOrAddMesh(scene, false, true);
  Mesh& mesh = scene.meshes[index];
  mesh.positions.insert(mesh.positions.end(), std::begin(triangle.p), std::end(triangle.p));
  mesh.normals.insert(mesh.normals.end(), std::begin(normals.n), std::end(normals.n));
  addTrianglesOf(scene, index, triangleCount(mesh) - 1, material);
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

void addMesh(Scene& scene, Mesh mesh, std::uint32_t material) {
  if (triangleCount(mesh) == 0) return;
  addTrianglesOf(scene, storeMesh(scene, std::move(mesh)), 0, material);
}

std::uint32_t storeMesh(Scene& scene, Mesh mesh) {
  if (scene.meshes.size() >= Primitive::kMaxMeshes) {
    throw FileError(fmt::format("the scene has more than {} meshes", Primitive::kMaxMeshes));
  }
  scene.meshes.push_back(std::move(mesh));
  return static_cast<std::uint32_t>(scene.meshes.size() - 1);
}

void addInstance(Scene& scene, std::uint32_t mesh, const Placement& placement, std::uint32_t material) {
  const auto count = static_cast<std::uint32_t>(triangleCount(scene.meshes[mesh]));
  if (count == 0) return;
  const auto index = static_cast<std::uint32_t>(scene.placements.size());
  scene.placements.push_back(placement);
  scene.primitives.append({PrimitiveKind::triangle, 0, material, mesh, index}, count);
}

void addIndexedTriangles(Scene& scene, std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                         std::uint32_t material) {
  if (indices.empty()) return;
  const std::uint32_t index = findOrAddMesh(scene, true, false);
  Mesh& mesh = scene.meshes[index];
  const std::size_t first = mesh.indices.size() / 3;
  const auto offset = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), positions.begin(), positions.end());
  mesh.indices.insert(mesh.indices.end(), indices.begin(), indices.end());
  for (std::size_t i = 3 * first; i < mesh.indices.size(); ++i) mesh.indices[i] += offset;
  addTrianglesOf(scene, index, first, material);
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

// Transforms meshes.
#include "host/formats/gltf/transform.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "host/base/finite.h"
#include "host/scene/placement.h"

namespace candela::gltf {
namespace {

/// The unit vector along v; 0 for v = 0 and for lengths that overflow.
glm::vec3 unitOrZero(const glm::dvec3& v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (largest == 0 || !std::isfinite(largest)) return glm::vec3(0);
  return glm::vec3(glm::normalize(v / largest));
}

struct VertexTransform {
  glm::dmat4 position;
  glm::dmat3 normal;  ///< the resulting normals have any length
  bool mirrors;

  explicit VertexTransform(const glm::dmat4& transform) : position(transform) {
    const glm::dmat3 linear(transform);
    mirrors = scene::mirrors(transform);
    normal = (mirrors ? -1.0 : 1.0) * scene::cofactorsOf(linear);
  }
};

void placeVertex(scene::Mesh& mesh, std::size_t i, const VertexTransform& transform, const Value& source) {
  mesh.positions[i] = glm::vec3(glm::dvec3(transform.position * glm::dvec4(mesh.positions[i], 1)));
  if (!isFinite(mesh.positions[i])) source.fail("a vertex is placed beyond the range of single precision");
  if (!mesh.normals.empty()) mesh.normals[i] = unitOrZero(transform.normal * glm::dvec3(mesh.normals[i]));
  if (mesh.tangents.empty()) return;
  const glm::vec4 tangent = mesh.tangents[i];
  const float handedness = (tangent.w < 0) != transform.mirrors ? -1.0f : 1.0f;
  mesh.tangents[i] = glm::vec4(unitOrZero(glm::dmat3(transform.position) * glm::dvec3(tangent)), handedness);
}

/// Reverses the triangle that begins at a corner.
void reverse(scene::Mesh& mesh, std::size_t corner) { std::swap(mesh.indices[corner + 1], mesh.indices[corner + 2]); }

/// The weighted mean of the matrices of a vertex's joints; the identity if the weights sum to nothing positive.
glm::dmat4 blend(const Influences& influences, std::size_t vertex, std::span<const glm::dmat4> joints,
                 const Value& source) {
  glm::dmat4 sum(0);
  double weightSum = 0;
  for (std::size_t set = 0; set < influences.joints.size(); ++set) {
    for (glm::length_t c = 0; c < 4; ++c) {
      const double weight = influences.weights[set][vertex][c];
      const std::uint32_t joint = influences.joints[set][vertex][c];
      if (joint >= joints.size()) {
        source.fail(fmt::format("vertex {} has joint {}, but the skin has {}", vertex, joint, joints.size()));
      }
      sum += weight * joints[joint];
      weightSum += weight;
    }
  }
  return weightSum > 0 ? sum / weightSum : glm::dmat4(1);
}

/// Replaces vertex normals of length 0 by the normal of the last triangle at the vertex.
void replaceZeroNormals(scene::Mesh& mesh) {
  if (std::ranges::find(mesh.normals, glm::vec3(0)) == mesh.normals.end()) return;
  const std::size_t count = mesh.indices.size();
  for (std::size_t i = 0; i + 2 < count; i += 3) {
    const std::uint32_t* const corner = &mesh.indices[i];
    bool isComplete = true;
    for (std::size_t c = 0; c < 3; ++c) isComplete = isComplete && mesh.normals[corner[c]] != glm::vec3(0);
    if (isComplete) continue;
    const glm::dvec3 p0(mesh.positions[corner[0]]);
    const glm::vec3 normal = unitOrZero(
        glm::cross(glm::dvec3(mesh.positions[corner[1]]) - p0, glm::dvec3(mesh.positions[corner[2]]) - p0));
    for (std::size_t c = 0; c < 3; ++c) {
      if (mesh.normals[corner[c]] == glm::vec3(0)) mesh.normals[corner[c]] = normal;
    }
  }
  for (glm::vec3& normal : mesh.normals) {
    if (normal == glm::vec3(0)) normal = glm::vec3(0, 0, 1);  // of a triangle without area, which is never hit
  }
}

}  // namespace

void place(scene::Mesh& mesh, const glm::dmat4& transform, const Value& source) {
  const VertexTransform forAll(transform);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) placeVertex(mesh, i, forAll, source);
  for (std::size_t corner = 0; forAll.mirrors && corner < mesh.indices.size(); corner += 3) reverse(mesh, corner);
  if (!mesh.normals.empty()) replaceZeroNormals(mesh);
}

void placeSkinned(scene::Mesh& mesh, const Influences& influences, std::span<const glm::dmat4> joints,
                  const Value& source) {
  std::vector<bool> mirrors(mesh.positions.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const VertexTransform transform(blend(influences, i, joints, source));
    placeVertex(mesh, i, transform, source);
    mirrors[i] = transform.mirrors;
  }
  for (std::size_t corner = 0; corner < mesh.indices.size(); corner += 3) {
    if (mirrors[mesh.indices[corner]]) reverse(mesh, corner);
  }
  if (!mesh.normals.empty()) replaceZeroNormals(mesh);
}

}  // namespace candela::gltf

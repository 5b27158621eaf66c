// Transforms meshes.
#include "host/formats/gltf/transform.h"

#include <fmt/format.h>

#include <cmath>
#include <span>

#include "host/base/finite.h"
#include "host/formats/loading/vertex_normals.h"
#include "host/scene/placement.h"

namespace candela::gltf {
namespace {

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
  if (!mesh.normals.empty()) mesh.normals[i] = scene::unitNormalOrZero(transform.normal * glm::dvec3(mesh.normals[i]));
  if (mesh.tangents.empty()) return;
  const glm::vec4 tangent = mesh.tangents[i];
  const float handedness = (tangent.w < 0) != transform.mirrors ? -1.0f : 1.0f;
  mesh.tangents[i] = glm::vec4(scene::unitNormalOrZero(glm::dmat3(transform.position) * glm::dvec3(tangent)),
                               handedness);
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

}  // namespace

void place(scene::Mesh& mesh, const glm::dmat4& transform, const Value& source) {
  const VertexTransform forAll(transform);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) placeVertex(mesh, i, forAll, source);
  for (std::size_t corner = 0; forAll.mirrors && corner < mesh.indices.size(); corner += 3) reverse(mesh, corner);
  if (!mesh.normals.empty()) scene::replaceZeroNormals(mesh);
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
  if (!mesh.normals.empty()) scene::replaceZeroNormals(mesh);
}

}  // namespace candela::gltf

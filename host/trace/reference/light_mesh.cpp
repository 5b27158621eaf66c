// Builds trees over the triangles of meshes, and bounds them where instances place them.
#include "host/trace/reference/light_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "host/image/film.h"
#include "host/trace/reference/textured_material.h"

namespace candela::reference {
namespace {

using Corners = std::array<dvec3, 3>;

Corners cornersOf(const scene::Scene& scene, const scene::Primitive& triangle) {
  const scene::Triangle vertices = triangleOf(scene, triangle);
  return {dvec3(vertices.p[0]), dvec3(vertices.p[1]), dvec3(vertices.p[2])};
}

double areaOf(const Corners& corners) { return length(cross(corners[1] - corners[0], corners[2] - corners[0])) / 2; }

bool mirrors(const scene::Placement& placement) { return determinant(linearPartOf(placement)) < 0; }

// The root of the sum of the squares of the entries.
double normOf(const glm::dmat3& matrix) {
  return std::sqrt(dot(matrix[0], matrix[0]) + dot(matrix[1], matrix[1]) + dot(matrix[2], matrix[2]));
}

}  // namespace

LightMesh::Key LightMesh::keyOf(const scene::Scene& scene, const scene::PrimitiveRun& run) {
  const scene::Primitive& start = run.start;
  return {start.mesh, start.index, scene.primitives.countOf(run), start.material,
          mirrors(scene.placements[start.placement])};
}

LightMesh::LightMesh(const scene::Scene& scene, const scene::PrimitiveRun& run, bool oneSided) {
  const bool isMirrored = mirrors(scene.placements[run.start.placement]);
  const dvec3 emission = scene.materials[run.start.material].emission;
  std::vector<LightBounds> bounds;
  std::vector<double> powers;
  for (std::uint32_t i = 0; i < scene.primitives.countOf(run); ++i) {
    scene::Primitive triangle = run.at(run.first + i);
    triangle.placement = scene::Primitive::kUnplaced;
    Corners corners = cornersOf(scene, triangle);
    const double luminance = image::luminance(emission * meanEmissionTexel(scene, triangle));
    const double power = areaOf(corners) * luminance;
    if (power <= 0) continue;
    if (isMirrored) std::swap(corners[1], corners[2]);
    parts_.push_back({i, luminance});
    bounds.push_back(boundsOfTriangle(corners, !oneSided));
    powers.push_back(power);
  }
  if (!parts_.empty()) tree_.emplace(std::move(bounds), std::move(powers), kMeshTreeDimensions);
}

std::optional<std::uint32_t> LightMesh::indexInTree(std::uint32_t triangle) const {
  const auto found = std::ranges::lower_bound(parts_, triangle, {}, &Part::triangle);
  if (found == parts_.end() || found->triangle != triangle) return std::nullopt;
  return static_cast<std::uint32_t>(found - parts_.begin());
}

LightInstance::LightInstance(const scene::Scene& scene, const scene::PrimitiveRun& run, const LightMesh& mesh,
                             std::uint32_t meshIndex, bool oneSided)
    : firstPrimitive_(run.first), mesh_(meshIndex) {
  std::vector<LightBounds> bounds;
  std::vector<double> powers;
  for (const LightMesh::Part& part : mesh.parts()) {
    const Corners corners = cornersOf(scene, run.at(run.first + part.triangle));
    const double power = areaOf(corners) * part.luminance;
    if (power <= 0) continue;
    power_ += power;
    bounds.push_back(boundsOfTriangle(corners, !oneSided));
    powers.push_back(power);
  }
  if (!bounds.empty()) bounds_ = LightTree::boundsOf(std::move(bounds), powers);
  const scene::Placement& placement = scene.placements[run.start.placement];
  linear_ = linearPartOf(placement);
  translation_ = translationOf(placement);
  inverse_ = glm::dmat3(inverseOf(placement));
  condition_ = static_cast<float>(normOf(linear_) * normOf(inverse_));
}

PlacedReceiver LightInstance::receiverInMesh(const LightReceiver& receiver) const {
  PlacedReceiver placed(receiver);
  placed.position = inverse_ * (receiver.position - translation_);
  placed.normal = normalize(transpose(linear_) * placed.normal);
  placed.condition = condition_;
  return placed;
}

}  // namespace candela::reference

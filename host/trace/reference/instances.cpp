// Inverts placements, and builds the BVHs of both levels.
#include "host/trace/reference/instances.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

#include "host/scene/stored_primitives.h"

namespace candela::reference {
namespace {

constexpr double kPlacedVertex = 5 * 0x1p-24;
constexpr double kSubnormal = 0x1p-147;

Hierarchy buildOverMesh(const scene::Scene& scene, const scene::PrimitiveRun& run, render::BvhSplit split) {
  const scene::Mesh& mesh = meshOf(scene, run.start);
  std::vector<Bounds> boxes(scene.primitives.countOf(run));
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    for (const glm::vec3& p : attributeOf(mesh, mesh.positions, run.start.index + i)) boxes[i].extend({p, p});
  }
  return buildHierarchy(boxes, split);
}

}  // namespace

Instance::Instance(const scene::Scene& scene, const scene::PrimitiveRun& run, std::uint32_t mesh,
                   const Bounds& meshBounds)
    : run_(run), mesh_(mesh) {
  const scene::Placement& placement = scene.placements[run.start.placement];
  const glm::dmat3 linear = linearPartOf(placement);
  toMesh_ = glm::inverse(linear);
  translation_ = translationOf(placement);
  stretch_ = maxNorm(scene::magnitudesOf(toMesh_) * dvec3(1));
  const dvec3 meshReach = glm::max(glm::abs(meshBounds.min), glm::abs(meshBounds.max));
  const double reach = maxNorm(scene::magnitudesOf(linear) * meshReach + glm::abs(translation_));
  padding_ = (kPlacedVertex + kWidening) * reach + kSubnormal;
  const dvec3 centre = linear * (0.5 * (meshBounds.min + meshBounds.max)) + translation_;
  const dvec3 halfSize = scene::magnitudesOf(linear) * (0.5 * (meshBounds.max - meshBounds.min)) + padding_;
  bounds_ = {centre - halfSize, centre + halfSize};
}

bool Instance::isInvertible() const { return std::isfinite(stretch_); }

Instances::Instances(const scene::Scene& scene, render::BvhSplit split) : split_(split) {
  const scene::StoredPrimitives stored(scene.primitives);
  const std::span<const scene::PrimitiveRun> runs = scene.primitives.runs();
  std::map<std::uint32_t, std::uint32_t> meshOfFirst;  // by the number of a run's first stored primitive
  isInstance_.resize(runs.size());
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!isInstance(scene, runs[i])) continue;
    const auto next = static_cast<std::uint32_t>(meshes_.size());
    const auto [entry, isNew] = meshOfFirst.try_emplace(stored.firstOf(i), next);
    if (isNew) meshes_.push_back(buildOverMesh(scene, runs[i], split));
    const Instance instance(scene, runs[i], entry->second, meshes_[entry->second].nodes.front().bounds);
    isInstance_[i] = instance.isInvertible();
    if (isInstance_[i]) instances_.push_back(instance);
  }
}

std::size_t Instances::nodeCount() const {
  std::size_t count = hierarchy_.nodes.size();
  for (const Hierarchy& mesh : meshes_) count += mesh.nodes.size();
  return count;
}

void Instances::build(double padding) {
  padding_ = padding;
  std::vector<Bounds> boxes;
  for (const Instance& instance : instances_) boxes.push_back(instance.bounds().padded(padding));
  hierarchy_ = buildHierarchy(boxes, split_);
}

}  // namespace candela::reference

// Descends only to boxes that may extend the result.
#include "host/scene/placed_bounds.h"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "host/base/run_on_threads.h"

namespace candela::scene {

Bounds PlacedBounds::of(const PrimitiveRun& run) {
  const Placement& placement = scene_.placements[run.start.placement];
  Bounds result{glm::vec3(INFINITY), glm::vec3(-INFINITY)};
  // Rounding is monotonic: the coordinates of a vertex in a box are between those of two corners of the box, which are
  // computed by the same operations.
  const auto extends = [&](const glm::vec3& low, const glm::vec3& high) {
    for (int axis = 0; axis < 3; ++axis) {
      const glm::vec4& row = placement.points[static_cast<std::size_t>(axis)];
      const glm::bvec3 rises = glm::greaterThanEqual(glm::vec3(row), glm::vec3(0));
      if (placedPoint(placement, glm::mix(low, high, rises))[axis] > result.max[axis]) return true;
      if (placedPoint(placement, glm::mix(high, low, rises))[axis] < result.min[axis]) return true;
    }
    return false;
  };
  WorkLimit limit(std::numeric_limits<std::uint64_t>::max());
  treeOf(run).visitItems(limit, extends, [&](std::uint32_t triangle) {
    Primitive primitive = run.start;
    primitive.index = triangle;
    for (const glm::vec3& vertex : triangleOf(scene_, primitive).p) {
      result.min = glm::min(result.min, vertex);
      result.max = glm::max(result.max, vertex);
    }
  });
  return result;
}

const BoxTree& PlacedBounds::treeOf(const PrimitiveRun& run) {
  const std::uint32_t count = scene_.primitives.countOf(run);
  std::unique_ptr<BoxTree>& tree = trees_[{run.start.mesh, run.start.index, count}];
  if (tree) return *tree;
  const Mesh& mesh = meshOf(scene_, run.start);
  std::vector<ItemBox> boxes;
  boxes.reserve(count);
  for (std::uint32_t i = run.start.index; i < run.start.index + count; ++i) {
    const auto [a, b, c] = attributeOf(mesh, mesh.positions, i);
    boxes.push_back({glm::min(glm::min(a, b), c), glm::max(glm::max(a, b), c), i});
  }
  tree = std::make_unique<BoxTree>(std::move(boxes), threadCountFor(0));
  return *tree;
}

}  // namespace candela::scene

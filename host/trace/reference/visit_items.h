// Visits the primitives that a ray may hit: all of them, or those that the BVHs or the grid lead to.
#pragma once
#include "host/trace/reference/hierarchy_traversal.h"
#include "host/trace/reference/tracing.h"

namespace candela::reference {

template <class Visit>
void Tracing::visitItems(const Ray& ray, const double& limit, Counters& counters, Visit&& visit) const {
  std::uint64_t& steps = counters.traversalSteps;
  const auto visitItem = [&](std::uint32_t i) { return visit(items_[i]); };
  if (!hierarchy_.nodes.empty() && traverse(hierarchy_, {ray.origin, ray.direction}, limit, steps, visitItem)) return;
  const auto visitTriangle = [&](const scene::PrimitiveRun& run, std::uint32_t primitive) {
    const Item item = madeItem(run.at(primitive), primitive);
    return isEverHit(item.shape) && visit(item);
  };
  if (!instances_.empty() && instances_.visit(ray, limit, steps, visitTriangle)) return;
  const bool throughGrid = hasGrid() && grid_.serves(ray.origin);
  if (throughGrid && visitGrid(ray, limit, counters, visit)) return;
  for (std::size_t i = hasGrid() && !throughGrid ? 0 : firstOutside_; i < items_.size(); ++i) {
    ++steps;
    if (visit(items_[i])) return;
  }
}

// A hit within a cell belongs to an item of the cell. Therefore the closest hit is final once it is before the exit
// from the cell.
template <class Visit>
bool Tracing::visitGrid(const Ray& ray, const double& limit, Counters& counters, Visit&& visit) const {
  for (GridTraversal traversal(grid_, ray); traversal.isInside(); traversal.advance()) {
    ++counters.traversalSteps;
    for (const std::uint32_t item : grid_.itemsOf(traversal.cell())) {
      ++counters.traversalSteps;
      if (visit(items_[item])) return true;
    }
    if (limit < traversal.exit()) return false;
  }
  return false;
}

}  // namespace candela::reference

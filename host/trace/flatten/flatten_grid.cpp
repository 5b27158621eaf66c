// Stores a uniform grid as 16-byte records.
#include "host/trace/accel/grid.h"
#include "host/trace/flatten/flatten_sections.h"

namespace candela::flatten {
namespace {

// Appends the cells. The last record is filled with the end of the last cell.
void appendCells(const accel::Grid& grid, Rows& rows) {
  const std::uint64_t cellCount = grid.shape.cellCount();
  const auto start = [&](std::uint64_t cell) { return grid.starts[std::min(cell, cellCount)]; };
  for (std::uint64_t cell = 0; cell < cellCount; cell += gpu::kCellsPerRow) {
    rows.push_back({start(cell), start(cell + 1), start(cell + 2), start(cell + 3)});
  }
}

// Returns primitives in the order in which cells first refer to them. Neighbours in space are then neighbours in
// memory.
std::vector<std::uint32_t> orderOf(const accel::Grid& grid, std::size_t primitiveCount) {
  std::vector<bool> named(primitiveCount);
  std::vector<std::uint32_t> order;
  order.reserve(primitiveCount);
  for (const std::uint32_t item : grid.items) {
    if (!named[item]) order.push_back(item);
    named[item] = true;
  }
  return order;
}

void appendItems(const accel::Grid& grid, std::span<const std::uint32_t> order, Rows& rows) {
  std::vector<std::uint32_t> slotOf(order.size());
  for (std::uint32_t slot = 0; slot < order.size(); ++slot) slotOf[order[slot]] = slot;
  const auto slot = [&](std::size_t i) { return i < grid.items.size() ? slotOf[grid.items[i]] : 0; };
  for (std::size_t i = 0; i < grid.items.size(); i += gpu::kItemsPerRow) {
    rows.push_back({slot(i), slot(i + 1), slot(i + 2), slot(i + 3)});
  }
}

void setConstants(const accel::GridShape& shape, gpu::RenderConstants& constants) {
  const glm::dvec3 extent = shape.bounds.extent();
  constants.gridLow = shape.bounds.min;
  constants.gridReach = gridReach(shape);
  constants.gridHigh = shape.bounds.max;
  constants.gridScale = shape.scale;
  constants.gridWidth = glm::vec3(extent / glm::dvec3(shape.sides));
  constants.gridSides = shape.sides;
  constants.gridStrides = shape.strides;
}

void noteQuality(const accel::Grid& grid, FlatScene& flat) {
  const accel::GridQuality measured = quality(grid);
  flat.structureQuality = {{"density", grid.density},
                           {"cells", static_cast<double>(measured.cellCount)},
                           {"cellsX", grid.shape.sides.x},
                           {"cellsY", grid.shape.sides.y},
                           {"cellsZ", grid.shape.sides.z},
                           {"references", static_cast<double>(measured.referenceCount)},
                           {"occupiedFraction", measured.occupiedFraction},
                           {"averageItems", measured.averageItems},
                           {"maxItems", measured.maxItems}};
}

}  // namespace

std::vector<std::uint32_t> appendGrid(const accel::SceneBounds& bounds, float density, std::uint32_t maxSide,
                                      FlatScene& flat) {
  if (bounds.bounds.empty()) return {};
  const accel::Grid grid = buildGrid(bounds.bounds, {.density = double{density}, .maxSide = maxSide});
  noteQuality(grid, flat);
  setConstants(grid.shape, flat.constants);
  flat.shape.structure = gpu::kStructureGrid;
  flat.constants.firstStructureRow = rowCount(flat.rows);
  flat.rows.reserve(flat.rows.size() + grid.starts.size() / gpu::kCellsPerRow + grid.items.size() / gpu::kItemsPerRow +
                    2);
  appendCells(grid, flat.rows);
  flat.constants.firstItemRow = rowCount(flat.rows);
  std::vector<std::uint32_t> order = orderOf(grid, bounds.finite.size());
  appendItems(grid, order, flat.rows);
  for (std::uint32_t& primitive : order) primitive = bounds.finite[primitive];
  return order;
}

}  // namespace candela::flatten

// Uniform grids over boxes. Knows nothing of primitives or of any device's layout.
//
// Why a walk through the grid finds what brute force finds. Boxes and rays err by u times a coordinate, u = 2^-24
// (primitive_bounds.h). Let o be the ray's origin, |o| its largest coordinate, G = gridReach(), B the box of a
// primitive that is hit at distance t, and x(t) = o + t d. The pads of the boxes leave x(t) at most 20 u |o| away from
// a point c of B. The primitive stands in the cell of c, since it stands in every cell that cellsOf(B) names. So a walk
// is right that visits, before it ends, at least one cell that it calls cell of c. It takes e = 32 u (|o| + G) and, on
// the axis along which the ray crosses most cells, one slice of cells after the other:
//
// - Slice i lies between the planes p(i) and p(i+1), p(i) = low + i * width. Rounding moves them against cellAt() by at
//   most 11 u G. The ray is within the slice between the distances (p(i) - (o + e)) / d and (p(i+1) - (o - e)) / d,
//   which err by 8 u (|o| + G) / d. Since e >= 20 u |o| + 11 u G + 8 u (|o| + G), the slice of c has t between the two.
// - Across that axis it visits the cells from cellAt(least coordinate in the slice - e) to cellAt(greatest + e). The
//   coordinates o + t d err by 4 u (|o| + G), rounding is monotonic in t, and e >= 20 u |o| + 4 u (|o| + G): the cell
//   of c is among them.
// - It begins at the slice, and ends at the distance, where the ray enters and leaves the grid's bounds widened by e.
// - Both distances grow from slice to slice. A walk may end as soon as the first of them exceeds the nearest hit, and
//   not before: whatever is nearer, or as near, has t in a slice that it has visited.
//
// So no cell needs a margin, zero components and origins far outside need no exception (e grows, and with it the number
// of cells visited), and a ray that runs along faces between cells visits both sides.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/accel/grid_shape.h"

namespace candela::accel {

struct GridOptions {
  double density = 2;                         ///< m of the rule, > 0
  std::uint32_t maxSide = kMostCellsPerAxis;  ///< cells along an axis, >= 1; never exceeded
  std::uint32_t threads = 0;                  ///< 0: one per core. The grid does not depend on it
};

/// Bounds of memory: cells, and references from cells to primitives.
std::uint64_t mostGridCells(std::size_t primitiveCount);
std::uint64_t mostGridReferences(std::size_t primitiveCount);

/// Cell c holds the primitives items[starts[c]] .. items[starts[c + 1] - 1], in ascending order. Without primitives
/// everything is empty.
struct Grid {
  GridShape shape;
  double density = 0;  ///< at which it was built: lower than asked for where the cells or references would be too many
  std::vector<std::uint32_t> starts;
  std::vector<std::uint32_t> items;

  bool operator==(const Grid&) const = default;
};

/// At most 2^27 boxes as requireProper() wants them. Throws InternalError where that or an option's range is violated.
Grid buildGrid(std::span<const Aabb> bounds, const GridOptions& options = {});

struct GridQuality {
  std::uint64_t cellCount = 0;
  std::uint64_t referenceCount = 0;
  double occupiedShare = 0;    ///< of cells that hold primitives
  double averageItems = 0;     ///< primitives in a cell that holds some
  std::uint32_t maxItems = 0;  ///< in one cell
};
/// Of a valid grid.
GridQuality quality(const Grid& grid);

/// What is wrong with a grid over `bounds`, or nothing: each primitive stands in the cells that its box touches and in
/// no other, once. Safe on any input.
std::optional<std::string> validate(const Grid& grid, std::span<const Aabb> bounds);

}  // namespace candela::accel

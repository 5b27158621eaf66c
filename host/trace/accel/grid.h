// Uniform grids over boxes, independent of primitives and of the layout on a device.
//
// A traversal of the grid finds the same hits as brute force, for the following reason. Boxes and rays have errors of u
// times a coordinate, u = 2^-24 (primitive_bounds.h). Let o be the origin of the ray, |o| its largest coordinate in
// magnitude, G = gridReach(), B the box of a primitive that is hit at distance t, and x(t) = o + t d. Because of the
// padding of the boxes, x(t) is at most 20 u |o| away from a point c of B. The primitive is in the cell of c, since it
// is in every cell of cellsOf(B). A traversal is therefore correct if it visits, before it ends, at least one cell that
// it regards as the cell of c. It uses the margin e = 32 u (|o| + G), and processes one slice of cells after the other
// along the axis on which the ray crosses the most cells:
//
// - Slice i lies between the planes p(i) and p(i+1), p(i) = low + i * width. Rounding moves them relative to cellAt()
//   by at most 11 u G. The ray is within the slice between the distances (p(i) - (o + e)) / d and (p(i+1) - (o - e)) /
//   d, which have errors of 8 u (|o| + G) / d. Since e >= 20 u |o| + 11 u G + 8 u (|o| + G), t is between the distances
//   of the slice of c.
// - On the other axes, the traversal visits the cells from cellAt(minimum coordinate in the slice - e) to
//   cellAt(maximum + e). The coordinates o + t d have errors of 4 u (|o| + G), rounding is monotonic in t, and e >= 20
//   u |o| + 4 u (|o| + G): the cell of c is among them.
// - It begins at the slice where the ray enters the bounds of the grid widened by e, and ends at the distance where the
//   ray leaves them.
// - Both distances increase from slice to slice. A traversal may end as soon as the first of them exceeds the closest
//   hit, but not earlier: any hit at this distance or closer has its t in a slice that has been visited.
//
// Hence no cell needs a margin. Zero components and origins far outside need no special case (e grows, and with it the
// number of visited cells), and a ray along faces between cells visits both sides.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/trace/accel/grid_shape.h"

namespace candela::accel {

struct GridOptions {
  double density = 2;                        ///< density m of the rule, > 0
  std::uint32_t maxSide = kMaxCellsPerAxis;  ///< maximum number of cells along an axis, >= 1
  std::uint32_t threads = 0;                 ///< 0: one per core; the grid does not depend on it
};

/// Limits of memory: numbers of cells, and of references from cells to primitives.
std::uint64_t maxGridCells(std::size_t primitiveCount);
std::uint64_t maxGridReferences(std::size_t primitiveCount);

/// Cell c contains the primitives items[starts[c]] .. items[starts[c + 1] - 1], in ascending order. Without primitives
/// all vectors are empty.
struct Grid {
  GridShape shape;
  double density = 0;  ///< density of the grid: lower than requested if there would be too many cells or references
  std::vector<std::uint32_t> starts;
  std::vector<std::uint32_t> items;

  bool operator==(const Grid&) const = default;
};

/// Builds a grid over at most 2^27 boxes that pass requireProper(). Throws InternalError if a box or an option is
/// invalid.
Grid buildGrid(std::span<const Aabb> bounds, const GridOptions& options = {});

struct GridQuality {
  std::uint64_t cellCount = 0;
  std::uint64_t referenceCount = 0;
  double occupiedFraction = 0;  ///< fraction of the cells that contain primitives
  double averageItems = 0;      ///< mean number of primitives in a cell that contains any
  std::uint32_t maxItems = 0;   ///< maximum number of primitives in a cell
};
/// Computes the quality of a valid grid.
GridQuality quality(const Grid& grid);

/// Returns the first error of a grid over `bounds`, or nothing: each primitive must be once in each cell that its box
/// touches, and in no other. Safe on any input.
std::optional<std::string> validate(const Grid& grid, std::span<const Aabb> bounds);

}  // namespace candela::accel

// A uniform grid over boxes in double precision, and its traversal by a ray (Amanatides and Woo, 1987).
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "host/trace/reference/hierarchy.h"
#include "host/trace/reference/ray.h"

namespace candela::reference {

using CellNumbers = std::array<std::int64_t, 3>;

/// Items are in every cell that their box touches once it is widened by `margin`, which far exceeds the errors of
/// distances in double precision. The traversal therefore need not distinguish the two cells of a point on a face.
struct Grid {
  Bounds bounds;  ///< around all boxes and their margins
  CellNumbers sides{0, 0, 0};
  dvec3 cellSize{0};
  double margin = 0;
  std::vector<std::uint64_t> starts;  ///< start of each cell's items, and the end; empty if there are no boxes
  std::vector<std::uint32_t> items;   ///< indices of boxes

  CellNumbers cellAt(const dvec3& point) const;
  std::size_t indexOf(const CellNumbers& cell) const {
    return static_cast<std::size_t>((cell[2] * sides[1] + cell[1]) * sides[0] + cell[0]);
  }
  std::span<const std::uint32_t> itemsOf(const CellNumbers& cell) const {
    const std::size_t index = indexOf(cell);
    return std::span(items).subspan(starts[index], starts[index + 1] - starts[index]);
  }
  /// Returns whether the margin covers the rounding errors of rays from `origin`. Rays from farther away have to test
  /// every primitive.
  bool serves(const dvec3& origin) const;
};

/// Builds a grid with about density^3 cells per box: the edge of a cell is 1 / density of the edge of the cube that is
/// a box's fraction of the volume (of the area or the length if the bounds are flat). Cells are larger if the number of
/// cells or items would be out of proportion to the boxes.
Grid buildGrid(std::span<const Bounds> boxes, double density);

/// The cells that a ray crosses, in order.
class GridTraversal {
 public:
  /// The grid must outlive this object.
  GridTraversal(const Grid& grid, const Ray& ray);

  bool isInside() const { return inside_; }
  const CellNumbers& cell() const { return cell_; }
  /// Distance along the ray at which it exits the cell.
  double exit() const;
  void advance();

 private:
  int nearestAxis() const;

  const Grid& grid_;
  bool inside_ = false;
  double entry_ = 0;  ///< distance at which the ray enters the grid; the distances below count from there
  CellNumbers cell_{0, 0, 0};
  CellNumbers step_{0, 0, 0};
  dvec3 next_{kNoHit};     ///< distance to the cell's far face on each axis
  dvec3 perCell_{kNoHit};  ///< distance between faces
};

}  // namespace candela::reference

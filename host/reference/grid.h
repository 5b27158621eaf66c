// A uniform grid over boxes in double precision, and the walk of a ray through it (Amanatides and Woo, 1987).
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "host/reference/hierarchy.h"
#include "host/reference/ray.h"

namespace candela::reference {

using CellNumbers = std::array<std::int64_t, 3>;

/// Items stand in every cell that their box touches once it is widened by `margin`, which is far more than distances
/// err by in double precision; so the walk needs no care about which of two cells a point on a face belongs to.
struct Grid {
  Bounds bounds;  ///< around all boxes and their margins
  CellNumbers sides{0, 0, 0};
  dvec3 cellSize{0};
  double margin = 0;
  std::vector<std::uint64_t> starts;  ///< of each cell's items, and the end; empty where there are no boxes
  std::vector<std::uint32_t> items;   ///< indices of boxes

  CellNumbers cellAt(const dvec3& point) const;
  std::size_t indexOf(const CellNumbers& cell) const {
    return static_cast<std::size_t>((cell[2] * sides[1] + cell[1]) * sides[0] + cell[0]);
  }
  std::span<const std::uint32_t> itemsOf(const CellNumbers& cell) const {
    const std::size_t index = indexOf(cell);
    return std::span(items).subspan(starts[index], starts[index + 1] - starts[index]);
  }
  /// Whether the margin covers the rounding of rays from here. Others, from far away, have to test everything.
  bool serves(const dvec3& origin) const;
};

/// About density^3 cells a box: the edge of a cell is 1 / density of what a box's share of the volume has, of the area
/// or the length where the bounds are flat. Larger where cells or items would be out of proportion to the boxes.
Grid buildGrid(std::span<const Bounds> boxes, double density);

/// The cells that a ray crosses, one after the other.
class GridWalk {
 public:
  /// The grid must outlive the walk.
  GridWalk(const Grid& grid, const Ray& ray);

  bool isInside() const { return inside_; }
  const CellNumbers& cell() const { return cell_; }
  /// Distance along the ray at which it leaves the cell.
  double exit() const;
  void advance();

 private:
  int nearestAxis() const;

  const Grid& grid_;
  bool inside_ = false;
  double entry_ = 0;  ///< where the ray enters the grid; the distances below count from there
  CellNumbers cell_{0, 0, 0};
  CellNumbers step_{0, 0, 0};
  dvec3 next_{kNoHit};     ///< to the cell's far face on each axis
  dvec3 perCell_{kNoHit};  ///< from one face to the next
};

}  // namespace candela::reference

// The geometry of a uniform grid: its cells without their content.
//
// The rule is a classical one: with the density m, the extent w of the box around N primitives, and s = (N / (w_x w_y
// w_z))^(1/3), axis i has trunc(m w_i s) + 1 cells, so that there are about m^3 cells per primitive. This rule divides
// by 0 if the box is flat, and has no limit: a long thin box around one primitive would get as many cells as the ratio
// of its length to its width. Three things are therefore different here.
//
// - Only axes with an extent count: s = (N / product of their w_i)^(1/k) over k = 3, 2 or 1 axes; the others have
//   one cell. An extent within the padding of the boxes (kThinnestCell times the largest coordinate) counts as none.
// - No cell is thinner than this padding, for the same reason.
// - The builder lowers the density until the numbers of cells and references are within limits that grow with N
//   (grid.h).
#pragma once
#include <array>
#include <cstdint>

#include "host/trace/accel/bounds.h"

namespace candela::accel {

/// Minimum thickness of a cell as a fraction of the largest coordinate of the grid: eight times the padding of boxes
/// (kBoundsPad).
inline constexpr double kThinnestCell = 0x1p-16;
/// Maximum number of cells along an axis: the index of a cell along an axis fits into 16 bits.
inline constexpr std::uint32_t kMaxCellsPerAxis = 65535;

/// The block of cells low .. high on each axis, both inclusive.
struct CellBlock {
  std::array<std::uint32_t, 3> low;
  std::array<std::uint32_t, 3> high;

  std::uint64_t cellCount() const {
    std::uint64_t count = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) count *= high[axis] - low[axis] + 1;
    return count;
  }
};

struct GridShape {
  Aabb bounds;            ///< the box around the boxes of all primitives
  glm::uvec3 sides{0};    ///< number of cells along each axis, 1 to kMaxCellsPerAxis; 0 if there are no primitives
  glm::uvec3 strides{0};  ///< cell (x, y, z) has the index dot(strides, (x, y, z))
  glm::vec3 scale{0};     ///< cells per unit of length; 0 along axes with one cell

  std::uint64_t cellCount() const { return std::uint64_t{sides.x} * sides.y * sides.z; }
  /// Returns the axis with the most cells. A layer of cells perpendicular to it has consecutive indices.
  int outermostAxis() const;

  /// Returns the cell along `axis` that contains coordinate x, or the outermost cell on its side. It is monotonic in x,
  /// including rounding, and defines the extent of the cells: the builder and all traversals must use this arithmetic.
  std::uint32_t cellAt(int axis, float x) const {
    const float cell = std::max(0.0f, (x - bounds.min[axis]) * scale[axis]);
    return static_cast<std::uint32_t>(std::min(cell, static_cast<float>(sides[axis] - 1)));
  }
  /// Returns all cells that the box touches.
  CellBlock cellsOf(const Aabb& box) const;

  bool operator==(const GridShape&) const = default;
};

/// Returns the shape of a grid over `primitiveCount` >= 1 primitives within `bounds`; density > 0.
GridShape gridShape(const Aabb& bounds, std::size_t primitiveCount, double density);

/// Returns the largest coordinate of the grid in magnitude.
float gridReach(const GridShape& shape);

}  // namespace candela::accel

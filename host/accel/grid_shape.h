// How a uniform grid cuts space: the cells, without what lies in them.
//
// The rule is the path-tracing report's: with m the density, w the extent of the box around N primitives and
// s = (N / (w_x w_y w_z))^(1/3), axis i gets trunc(m w_i s) + 1 cells, so about m^3 cells a primitive. As it stands it
// divides by 0 where the box is flat, and knows no bound: a needle of a box around one primitive would get as many
// cells as it is longer than wide. Three things are therefore different here.
//
// - Only axes with extent take part: s = (N / product of their w_i)^(1/k) over k = 3, 2 or 1 axes, and the others have
//   one cell. An extent within the padding of the boxes (kThinnestCell of the largest coordinate) is none.
// - No cell is thinner than that, for the same reason.
// - The builder lowers the density until cells and references stay within bounds that grow with N (grid.h).
#pragma once
#include <array>
#include <cstdint>

#include "host/accel/bounds.h"

namespace candela::accel {

/// Thinnest cell as a share of the grid's largest coordinate: eight times what boxes are padded by (kBoundsPad).
inline constexpr double kThinnestCell = 0x1p-16;
/// Most cells along an axis, whatever is asked for: a cell number fits into 16 bits.
inline constexpr std::uint32_t kMostCellsPerAxis = 65535;

/// The block of cells low .. high on each axis, both included.
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
  Aabb bounds;            ///< the box around all primitives' boxes
  glm::uvec3 sides{0};    ///< cells along each axis, 1 to kMostCellsPerAxis; 0 where there are no primitives
  glm::uvec3 strides{0};  ///< cell (x, y, z) is number dot(strides, (x, y, z))
  glm::vec3 scale{0};     ///< cells per unit of length; 0 along axes of one cell

  std::uint64_t cellCount() const { return std::uint64_t{sides.x} * sides.y * sides.z; }
  /// The one with most cells: a layer of cells across it has consecutive numbers.
  int outermostAxis() const;

  /// The cell along `axis` that holds coordinate x, or the outermost on its side. Monotonic in x, rounding included,
  /// and the one place where cells get their extent: builder and traversals must all use this arithmetic.
  std::uint32_t cellAt(int axis, float x) const {
    const float place = std::max(0.0f, (x - bounds.min[axis]) * scale[axis]);
    return static_cast<std::uint32_t>(std::min(place, static_cast<float>(sides[axis] - 1)));
  }
  /// All cells that the box touches.
  CellBlock cellsOf(const Aabb& box) const;

  bool operator==(const GridShape&) const = default;
};

/// The grid over `primitiveCount` >= 1 primitives within `bounds`; density > 0.
GridShape gridShape(const Aabb& bounds, std::size_t primitiveCount, double density);

/// The largest coordinate of the grid in magnitude.
float gridReach(const GridShape& shape);

}  // namespace candela::accel

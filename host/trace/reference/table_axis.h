// Interpolation along one dimension of a table.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>

namespace candela::reference {

/// The position between the nodes `node` and `node` + 1, of which the second has the weight `part`.
struct TableAxis {
  std::size_t node = 0;
  double part = 0;

  TableAxis() = default;

  /// `fraction` of the way from the first to the last of `nodes` nodes; outside of [0, 1] it is the nearer end.
  TableAxis(double fraction, std::size_t nodes) {
    const double scaled = std::clamp(fraction, 0.0, 1.0) * static_cast<double>(nodes - 1);
    node = std::min(static_cast<std::size_t>(scaled), nodes - 2);
    part = scaled - static_cast<double>(node);
  }
};

/// Interpolates linearly in all dimensions of a table, whose numbers of nodes are `sizes`. The nodes of the last
/// dimension are next to each other.
template <std::size_t kDimensions>
double interpolateTable(const float* nodes, const std::array<double, kDimensions>& fractions,
                        const std::array<std::size_t, kDimensions>& sizes) {
  std::array<TableAxis, kDimensions> axes{};
  for (std::size_t d = 0; d < kDimensions; ++d) axes[d] = TableAxis(fractions[d], sizes[d]);
  double sum = 0;
  for (std::size_t corner = 0; corner < std::size_t{1} << kDimensions; ++corner) {
    double weight = 1;
    std::size_t index = 0;
    for (std::size_t d = 0; d < kDimensions; ++d) {
      const std::size_t upper = corner >> d & 1;
      weight *= upper != 0 ? axes[d].part : 1 - axes[d].part;
      index = index * sizes[d] + axes[d].node + upper;
    }
    sum += weight * double{nodes[index]};
  }
  return sum;
}

}  // namespace candela::reference

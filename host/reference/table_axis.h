// Interpolation along one dimension of a table.
#pragma once
#include <algorithm>
#include <cstddef>

namespace candela::reference {

/// A place between the nodes `node` and `node` + 1, of which the second has the weight `part`.
struct TableAxis {
  std::size_t node;
  double part;

  /// `fraction` of the way from the first to the last of `nodes` nodes; outside of [0, 1] it is the nearer end.
  TableAxis(double fraction, std::size_t nodes) {
    const double scaled = std::clamp(fraction, 0.0, 1.0) * static_cast<double>(nodes - 1);
    node = std::min(static_cast<std::size_t>(scaled), nodes - 2);
    part = scaled - static_cast<double>(node);
  }

  struct End {
    std::size_t node;
    double weight;
  };
  /// Returns the lower node or the upper one, with its weight.
  End end(bool upper) const { return upper ? End{node + 1, part} : End{node, 1 - part}; }
};

}  // namespace candela::reference

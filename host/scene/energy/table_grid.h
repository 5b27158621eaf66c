// Tables of several dimensions, whose nodes are raised so that interpolation does not fall short within cells:
// docs/light-transport.md section 5.12.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace candela::energy {

/// The nodes of a table. Those of the first dimension are next to each other.
template <std::size_t kDimensions>
class TableGrid {
 public:
  using Point = std::array<double, kDimensions>;

  /// The value that interpolation should have in the cell that begins at `node`, at the fractions `point` of its edges.
  struct Probe {
    std::size_t node;
    Point point;
    double value;
  };

  explicit TableGrid(const std::array<std::size_t, kDimensions>& sizes) : sizes_(sizes) {}

  std::size_t size() const {
    std::size_t size = 1;
    for (const std::size_t s : sizes_) size *= s;
    return size;
  }

  /// Returns a point in the cell that begins at `node`, in fractions of the table's edges.
  Point pointIn(std::size_t node, const Point& point = {}) const {
    Point result{};
    for (std::size_t d = 0; d < kDimensions; ++d) {
      result[d] = (static_cast<double>(node % sizes_[d]) + point[d]) / static_cast<double>(sizes_[d] - 1);
      node /= sizes_[d];
    }
    return result;
  }

  /// Returns whether a cell begins at `node`: whether it is on no upper border.
  bool beginsCell(std::size_t node) const {
    for (const std::size_t size : sizes_) {
      if (node % size + 1 == size) return false;
      node /= size;
    }
    return true;
  }

  /// Returns the nodes, raised until interpolation falls short of no probe.
  std::vector<double> raised(std::vector<double> nodes, const std::vector<Probe>& probes) const {
    std::vector<double> shortfall(nodes.size());
    for (const Probe& probe : probes) {
      double value = 0;
      for (std::size_t i = 0; i < kCorners; ++i) value += weightOf(i, probe.point) * nodes[corner(i, probe.node)];
      for (std::size_t i = 0; i < kCorners; ++i) {
        double& most = shortfall[corner(i, probe.node)];
        most = std::max(most, probe.value - value);
      }
    }
    for (std::size_t node = 0; node < nodes.size(); ++node) nodes[node] += shortfall[node];
    return nodes;
  }

 private:
  static constexpr std::size_t kCorners = std::size_t{1} << kDimensions;

  // Bit d of a corner's number is set at the upper end of dimension d.
  static double weightOf(std::size_t number, const Point& point) {
    double weight = 1;
    for (std::size_t d = 0; d < kDimensions; ++d) weight *= number >> d & 1 ? point[d] : 1 - point[d];
    return weight;
  }
  std::size_t corner(std::size_t number, std::size_t node) const {
    std::size_t stride = 1;
    for (std::size_t d = 0; d < kDimensions; ++d) {
      if (number >> d & 1) node += stride;
      stride *= sizes_[d];
    }
    return node;
  }

  std::array<std::size_t, kDimensions> sizes_;
};

/// Returns the steps of a sequence of points in a unit cube, the fractions of 1/2 + i step, that has a low discrepancy:
/// powers of the generalised golden ratio (Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences", 2018).
template <std::size_t kDimensions>
std::array<double, kDimensions> quasirandomSteps() {
  double ratio = 1;
  for (int i = 0; i < 60; ++i) ratio = std::pow(1 + ratio, 1 / (kDimensions + 1.0));
  std::array<double, kDimensions> steps;
  for (std::size_t d = 0; d < kDimensions; ++d) steps[d] = std::pow(ratio, -1.0 - static_cast<double>(d));
  return steps;
}

}  // namespace candela::energy

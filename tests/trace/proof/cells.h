// Counts over a grid of cells of the unit square.
#pragma once
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>
#include <vector>

namespace candela::proof {

/// Cells of a unit square, and one more for points outside of it and for samples without a point.
class Cells {
 public:
  Cells(int rows, int columns)
      : rows_(rows),
        columns_(columns),
        counts_(static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns) + 1) {}

  void add(const glm::dvec2& place, double amount = 1) { counts_[cellOf(place)] += amount; }
  void addOutside(double amount = 1) { counts_.back() += amount; }
  std::vector<double>& counts() { return counts_; }
  const std::vector<double>& counts() const { return counts_; }

 private:
  // Rounding may move a point of the outermost cells beyond them.
  static constexpr double kSlack = 1e-6;

  std::size_t cellOf(const glm::dvec2& place) const {
    const bool inside = place.x >= -kSlack && place.x <= 1 + kSlack && place.y >= -kSlack && place.y <= 1 + kSlack;
    if (!inside) return counts_.size() - 1;
    const auto index = [](double value, int count) {
      return static_cast<std::size_t>(std::clamp(static_cast<int>(value * count), 0, count - 1));
    };
    return index(place.x, rows_) * static_cast<std::size_t>(columns_) + index(place.y, columns_);
  }

  int rows_;
  int columns_;
  std::vector<double> counts_;
};

/// Returns the expected counts of `total` points that are uniform on the unit square.
inline std::vector<double> uniformCounts(int rows, int columns, double total) {
  Cells cells(rows, columns);
  std::fill(cells.counts().begin(), cells.counts().end() - 1, total / (double{1} * rows * columns));
  return cells.counts();
}

/// Returns the azimuth as a fraction of the full circle, in [0, 1).
inline double turns(double x, double y) {
  const double turn = std::atan2(y, x) / (2 * std::numbers::pi);
  return turn < 0 ? turn + 1 : turn;
}

/// The direction with this cosine to z and this azimuth.
inline glm::dvec3 directionAt(double z, double turn) {
  const double r = std::sqrt(std::max(0.0, 1 - z * z)), phi = 2 * std::numbers::pi * turn;
  return {r * std::cos(phi), r * std::sin(phi), z};
}

}  // namespace candela::proof

// Quadrature over the hemisphere.
#pragma once
#include <boost/math/quadrature/gauss.hpp>
#include <glm/glm.hpp>
#include <vector>

#include "tests/trace/proof/cells.h"

namespace candela::proof {

struct QuadraturePoint {
  glm::dvec3 direction;
  glm::dvec2 place;   ///< (z, turn) in the unit square
  double solidAngle;  ///< that the point represents; 2 pi in total
};

/// Gauss and Legendre's points, `Order` of them along each side of every cell; rows of equal height z, columns of equal
/// azimuth.
template <unsigned Order>
class GaussGrid {
 public:
  using Point = QuadraturePoint;

  GaussGrid(int rows, int columns) {
    const std::vector<Node> heights = nodes(rows), azimuths = nodes(columns);
    for (const Node& z : heights) {
      for (const Node& turn : azimuths) {
        const double solidAngle = 2 * std::numbers::pi * z.weight * turn.weight;
        points_.push_back({directionAt(z.at, turn.at), {z.at, turn.at}, solidAngle});
      }
    }
  }
  const std::vector<Point>& points() const { return points_; }

 private:
  struct Node {
    double at;
    double weight;
  };

  // On [0, 1] in `cells` equal parts. Boost lists the points from the middle on; their mirror images weigh the same.
  static std::vector<Node> nodes(int cells) {
    using Rule = boost::math::quadrature::gauss<double, Order>;
    std::vector<Node> result;
    for (int cell = 0; cell < cells; ++cell) {
      for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
        const double x = Rule::abscissa()[i], weight = Rule::weights()[i] / (2 * cells);
        result.push_back({(cell + (1 + x) / 2) / cells, weight});
        if (x != 0) result.push_back({(cell + (1 - x) / 2) / cells, weight});
      }
    }
    return result;
  }

  std::vector<Point> points_;
};

using HemisphereGrid = GaussGrid<7>;

}  // namespace candela::proof

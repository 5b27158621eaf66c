// The rule for the number of cells, with the exceptions of grid_shape.h.
#include "host/trace/accel/grid_shape.h"

#include <cmath>

namespace candela::accel {
namespace {

double reachOf(const Aabb& bounds) {
  const glm::vec3 reach = glm::max(glm::abs(bounds.min), glm::abs(bounds.max));
  return double{std::max({reach.x, reach.y, reach.z})};
}

// For smaller extents, the scale would overflow.
constexpr double kMinCellSize = 0x1p-100;

// Returns s of the rule: the number of primitives per unit of length on the axes with an extent.
double linearDensity(const glm::dvec3& extent, double thinnest, std::size_t primitiveCount) {
  double product = 1;
  int axes = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (extent[axis] <= thinnest) continue;
    product *= extent[axis];
    ++axes;
  }
  return axes == 0 ? 0 : std::pow(static_cast<double>(primitiveCount) / product, 1.0 / axes);
}

glm::uvec3 stridesOf(const glm::uvec3& sides, int outermost) {
  const int inner = outermost == 0 ? 1 : 0, middle = outermost == 2 ? 1 : 2;
  glm::uvec3 strides;
  strides[inner] = 1;
  strides[middle] = sides[inner];
  strides[outermost] = sides[inner] * sides[middle];
  return strides;
}

}  // namespace

int GridShape::outermostAxis() const {
  int outermost = 2;
  for (int axis : {1, 0}) {
    if (sides[axis] > sides[outermost]) outermost = axis;
  }
  return outermost;
}

CellBlock GridShape::cellsOf(const Aabb& box) const {
  return {{cellAt(0, box.min.x), cellAt(1, box.min.y), cellAt(2, box.min.z)},
          {cellAt(0, box.max.x), cellAt(1, box.max.y), cellAt(2, box.max.z)}};
}

GridShape gridShape(const Aabb& bounds, std::size_t primitiveCount, double density) {
  GridShape shape;
  shape.bounds = bounds;
  const glm::dvec3 extent = bounds.extent();
  const double thinnest = std::max(kThinnestCell * reachOf(bounds), kMinCellSize);
  const double s = linearDensity(extent, thinnest, primitiveCount);
  for (int axis = 0; axis < 3; ++axis) {
    shape.sides[axis] = 1;
    if (extent[axis] <= thinnest) continue;
    const double wanted = std::trunc(density * extent[axis] * s) + 1;
    const double maxSide = std::min<double>(std::trunc(extent[axis] / thinnest), kMaxCellsPerAxis);
    shape.sides[axis] = static_cast<std::uint32_t>(std::min(wanted, maxSide));
    if (shape.sides[axis] > 1) shape.scale[axis] = static_cast<float>(shape.sides[axis] / extent[axis]);
  }
  shape.strides = stridesOf(shape.sides, shape.outermostAxis());
  return shape;
}

float gridReach(const GridShape& shape) { return static_cast<float>(reachOf(shape.bounds)); }

}  // namespace candela::accel

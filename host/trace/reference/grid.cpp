// Sizes cells by the edge of a cube and sorts items by counting. The traversal measures distances from the point where
// the ray enters the grid, so that errors stay small.
#include "host/trace/reference/grid.h"

#include <algorithm>
#include <cmath>

namespace candela::reference {
namespace {

constexpr double kMargin = 1e-6;  // as a fraction of the grid's largest coordinate
constexpr double kThinnestCell = 1e-4;
constexpr double kFarAway = 100;
constexpr double kMaxCellsPerBox = 64;
constexpr double kMaxItemsPerBox = 64;
constexpr double kSmallGrid = 1000;  // number of cells and items that is always permitted

double largest(const dvec3& v) { return std::max({v.x, v.y, v.z}); }

double reachOf(const Bounds& bounds) { return largest(glm::max(glm::abs(bounds.min), glm::abs(bounds.max))); }

// Returns the edge of the cube, square or interval that is the fraction of one of `count` boxes.
double edgePerBox(const dvec3& extent, double thinnest, std::size_t count) {
  double logVolume = 0;
  int dimensions = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (extent[axis] < thinnest) continue;
    logVolume += std::log(extent[axis]);
    ++dimensions;
  }
  if (dimensions == 0) return largest(extent);
  return std::exp((logVolume - std::log(static_cast<double>(count))) / dimensions);
}

void setCells(Grid& grid, double edge) {
  const dvec3 extent = grid.bounds.max - grid.bounds.min;
  for (int axis = 0; axis < 3; ++axis) {
    const double cells = edge > 0 ? std::floor(extent[axis] / edge) + 1 : 1;
    grid.sides[static_cast<std::size_t>(axis)] = static_cast<std::int64_t>(cells);
    grid.cellSize[axis] = extent[axis] / cells;
  }
}

double cellCount(const Grid& grid) {
  return static_cast<double>(grid.sides[0]) * static_cast<double>(grid.sides[1]) * static_cast<double>(grid.sides[2]);
}

struct Block {
  CellNumbers low;
  CellNumbers high;
};

Block blockOf(const Grid& grid, const Bounds& box) {
  return {grid.cellAt(box.min - grid.margin), grid.cellAt(box.max + grid.margin)};
}

double itemCount(const Grid& grid, std::span<const Bounds> boxes) {
  double count = 0;
  for (const Bounds& box : boxes) {
    const auto [low, high] = blockOf(grid, box);
    double cells = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) cells *= static_cast<double>(high[axis] - low[axis] + 1);
    count += cells;
  }
  return count;
}

template <class Visit>
void forEachCell(const Block& block, Visit&& visit) {
  for (std::int64_t z = block.low[2]; z <= block.high[2]; ++z) {
    for (std::int64_t y = block.low[1]; y <= block.high[1]; ++y) {
      for (std::int64_t x = block.low[0]; x <= block.high[0]; ++x) visit(CellNumbers{x, y, z});
    }
  }
}

void fill(Grid& grid, std::span<const Bounds> boxes) {
  grid.starts.assign(static_cast<std::size_t>(cellCount(grid)) + 1, 0);
  for (const Bounds& box : boxes) {
    forEachCell(blockOf(grid, box), [&](const CellNumbers& cell) { ++grid.starts[grid.indexOf(cell) + 1]; });
  }
  for (std::size_t i = 1; i < grid.starts.size(); ++i) grid.starts[i] += grid.starts[i - 1];
  std::vector<std::uint64_t> next = grid.starts;
  grid.items.resize(grid.starts.back());
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    forEachCell(blockOf(grid, boxes[i]), [&](const CellNumbers& cell) { grid.items[next[grid.indexOf(cell)]++] = i; });
  }
}

}  // namespace

CellNumbers Grid::cellAt(const dvec3& point) const {
  CellNumbers cell{0, 0, 0};
  for (int axis = 0; axis < 3; ++axis) {
    const auto last = static_cast<double>(sides[static_cast<std::size_t>(axis)] - 1);
    const double index = cellSize[axis] > 0 ? std::floor((point[axis] - bounds.min[axis]) / cellSize[axis]) : 0;
    cell[static_cast<std::size_t>(axis)] = static_cast<std::int64_t>(std::clamp(index, 0.0, last));
  }
  return cell;
}

bool Grid::serves(const dvec3& origin) const { return largest(glm::abs(origin)) <= kFarAway * reachOf(bounds); }

Grid buildGrid(std::span<const Bounds> boxes, double density) {
  Grid grid;
  if (boxes.empty()) return grid;
  for (const Bounds& box : boxes) grid.bounds.extend(box);
  const double reach = reachOf(grid.bounds);
  grid.margin = kMargin * reach;
  grid.bounds = {grid.bounds.min - grid.margin, grid.bounds.max + grid.margin};
  const double thinnest = kThinnestCell * reach;
  const auto count = static_cast<double>(boxes.size());
  const auto isTooLarge = [&] {
    return cellCount(grid) > kSmallGrid + kMaxCellsPerBox * count ||
           itemCount(grid, boxes) > kSmallGrid + kMaxItemsPerBox * count;
  };
  const dvec3 extent = grid.bounds.max - grid.bounds.min;
  double edge = std::max(thinnest, edgePerBox(extent, thinnest, boxes.size()) / density);
  for (setCells(grid, edge); isTooLarge(); setCells(grid, edge)) edge *= 1.5;
  fill(grid, boxes);
  return grid;
}

// ---------------------------------------------------------------------------------------------------------------------

GridTraversal::GridTraversal(const Grid& grid, const Ray& ray) : grid_(grid) {
  double exit = kNoHit;
  for (int axis = 0; axis < 3; ++axis) {
    const double o = ray.origin[axis], d = ray.direction[axis];
    const double low = grid.bounds.min[axis], high = grid.bounds.max[axis];
    if (d == 0) {
      if (o < low || o > high) return;
      continue;
    }
    entry_ = std::max(entry_, ((d > 0 ? low : high) - o) / d);
    exit = std::min(exit, ((d > 0 ? high : low) - o) / d);
  }
  // The margin surrounds everything that can be hit: rounding only removes empty space from the bounds.
  inside_ = entry_ <= exit;
  if (!inside_) return;
  const dvec3 start = ray.at(entry_);
  cell_ = grid.cellAt(start);
  for (int axis = 0; axis < 3; ++axis) {
    const double d = ray.direction[axis];
    if (d == 0) continue;
    const auto number = static_cast<std::size_t>(axis);
    step_[number] = d > 0 ? 1 : -1;
    const double face = grid.bounds.min[axis] + static_cast<double>(cell_[number] + (d > 0)) * grid.cellSize[axis];
    next_[axis] = (face - start[axis]) / d;
    perCell_[axis] = grid.cellSize[axis] / std::abs(d);
  }
}

int GridTraversal::nearestAxis() const {
  if (next_.x <= next_.y && next_.x <= next_.z) return 0;
  return next_.y <= next_.z ? 1 : 2;
}

double GridTraversal::exit() const { return entry_ + next_[nearestAxis()]; }

void GridTraversal::advance() {
  const int axis = nearestAxis();
  const auto number = static_cast<std::size_t>(axis);
  cell_[number] += step_[number];
  next_[axis] += perCell_[axis];
  inside_ = cell_[number] >= 0 && cell_[number] < grid_.sides[number];
}

}  // namespace candela::reference

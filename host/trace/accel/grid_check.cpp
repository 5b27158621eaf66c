// Computes the quality of finished grids, and validates them.
#include <fmt/format.h>

#include <algorithm>

#include "host/trace/accel/grid.h"

namespace candela::accel {
namespace {

class GridValidator {
 public:
  GridValidator(const Grid& grid, std::span<const Aabb> bounds) : grid_(grid), bounds_(bounds) {}

  std::optional<std::string> run() const {
    if (bounds_.empty()) return checkEmpty();
    if (auto problem = checkShape()) return problem;
    if (auto problem = checkStarts()) return problem;
    if (auto problem = checkCells()) return problem;
    return checkPrimitives();
  }

 private:
  std::optional<std::string> checkEmpty() const {
    if (grid_.starts.empty() && grid_.items.empty()) return std::nullopt;
    return fmt::format("{} starts and {} items for no primitives", grid_.starts.size(), grid_.items.size());
  }

  std::optional<std::string> checkShape() const {
    const GridShape& shape = grid_.shape;
    for (int axis = 0; axis < 3; ++axis) {
      if (shape.sides[axis] < 1 || shape.sides[axis] > kMaxCellsPerAxis) {
        return fmt::format("{} cells along axis {}", shape.sides[axis], axis);
      }
      const bool cut = shape.sides[axis] > 1;
      if (!std::isfinite(shape.scale[axis]) || (cut ? shape.scale[axis] <= 0 : shape.scale[axis] != 0)) {
        return fmt::format("scale {} of {} cells along axis {}", shape.scale[axis], shape.sides[axis], axis);
      }
    }
    if (const auto problem = checkStrides()) return problem;
    for (std::size_t i = 0; i < bounds_.size(); ++i) {
      if (!shape.bounds.contains(bounds_[i])) return fmt::format("primitive {} reaches out of the grid", i);
    }
    return std::nullopt;
  }

  // For some order of the axes, each stride is the product of the sides before it: no two cells have the same index.
  std::optional<std::string> checkStrides() const {
    const GridShape& shape = grid_.shape;
    std::array<int, 3> axes{0, 1, 2};
    do {
      const auto [a, b, c] = axes;
      const std::uint64_t layer = std::uint64_t{shape.sides[a]} * shape.sides[b];
      if (shape.strides[a] == 1 && shape.strides[b] == shape.sides[a] && shape.strides[c] == layer) return std::nullopt;
    } while (std::next_permutation(axes.begin(), axes.end()));
    return fmt::format("strides {} {} {} of {} x {} x {} cells", shape.strides.x, shape.strides.y, shape.strides.z,
                       shape.sides.x, shape.sides.y, shape.sides.z);
  }

  std::optional<std::string> checkStarts() const {
    const auto& starts = grid_.starts;
    if (starts.size() != grid_.shape.cellCount() + 1) {
      return fmt::format("{} starts of {} cells", starts.size(), grid_.shape.cellCount());
    }
    if (starts.front() != 0) return fmt::format("cell 0 starts at {}", starts.front());
    for (std::size_t cell = 0; cell + 1 < starts.size(); ++cell) {
      if (starts[cell] > starts[cell + 1]) return fmt::format("cell {} ends before it starts", cell);
    }
    if (starts.back() == grid_.items.size()) return std::nullopt;
    return fmt::format("the last cell ends at {} of {} items", starts.back(), grid_.items.size());
  }

  std::span<const std::uint32_t> itemsOf(std::size_t cell) const {
    return std::span(grid_.items).subspan(grid_.starts[cell], grid_.starts[cell + 1] - grid_.starts[cell]);
  }

  std::optional<std::string> checkCells() const {
    for (std::size_t cell = 0; cell + 1 < grid_.starts.size(); ++cell) {
      const auto items = itemsOf(cell);
      for (std::size_t i = 0; i < items.size(); ++i) {
        if (items[i] >= bounds_.size()) return fmt::format("cell {} names primitive {}", cell, items[i]);
        if (i > 0 && items[i] <= items[i - 1]) return fmt::format("the items of cell {} do not ascend", cell);
      }
    }
    return std::nullopt;
  }

  // Each primitive is in all of its cells, and the number of references is equal: it is in no other cell.
  std::optional<std::string> checkPrimitives() const {
    std::uint64_t references = 0;
    for (std::uint32_t primitive = 0; primitive < bounds_.size(); ++primitive) {
      const CellBlock block = grid_.shape.cellsOf(bounds_[primitive]);
      if (const auto missing = missingFrom(block, primitive)) {
        return fmt::format("primitive {} is not in cell {}", primitive, *missing);
      }
      references += block.cellCount();
    }
    if (references == grid_.items.size()) return std::nullopt;
    return fmt::format("{} items, but boxes touch cells {} times", grid_.items.size(), references);
  }

  std::optional<std::uint32_t> missingFrom(const CellBlock& block, std::uint32_t primitive) const {
    const glm::uvec3& strides = grid_.shape.strides;
    for (std::uint32_t z = block.low[2]; z <= block.high[2]; ++z) {
      for (std::uint32_t y = block.low[1]; y <= block.high[1]; ++y) {
        for (std::uint32_t x = block.low[0]; x <= block.high[0]; ++x) {
          const std::uint32_t cell = x * strides.x + y * strides.y + z * strides.z;
          const auto items = itemsOf(cell);
          if (!std::binary_search(items.begin(), items.end(), primitive)) return cell;
        }
      }
    }
    return std::nullopt;
  }

  const Grid& grid_;
  std::span<const Aabb> bounds_;
};

}  // namespace

std::optional<std::string> validate(const Grid& grid, std::span<const Aabb> bounds) {
  return GridValidator(grid, bounds).run();
}

GridQuality quality(const Grid& grid) {
  GridQuality result;
  if (grid.starts.empty()) return result;
  result.cellCount = grid.starts.size() - 1;
  result.referenceCount = grid.items.size();
  std::uint64_t occupied = 0;
  for (std::size_t cell = 0; cell < result.cellCount; ++cell) {
    const std::uint32_t count = grid.starts[cell + 1] - grid.starts[cell];
    occupied += count > 0;
    result.maxItems = std::max(result.maxItems, count);
  }
  result.occupiedFraction = static_cast<double>(occupied) / static_cast<double>(result.cellCount);
  result.averageItems = static_cast<double>(result.referenceCount) / static_cast<double>(occupied);
  return result;
}

}  // namespace candela::accel

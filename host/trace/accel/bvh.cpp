// Builds the BVH: large ranges fork into tasks, small ones become subtrees, and all are joined in a fixed order.
#include "host/trace/accel/bvh.h"

#include <fmt/format.h>

#include <array>
#include <atomic>
#include <memory>

#include "host/base/errors.h"
#include "host/base/run_on_threads.h"
#include "host/trace/accel/build_range.h"
#include "host/trace/accel/reinsertion.h"
#include "host/trace/accel/task_pool.h"

namespace candela::accel {
namespace {

constexpr std::size_t kMaxBvhPrimitives = std::size_t{1} << 31;
// Ranges with fewer items are one task. The value does not depend on the machine.
constexpr std::size_t kTaskItems = std::size_t{1} << 14;

void requireOptions(const BvhOptions& options, std::size_t itemCount) {
  if (itemCount > kMaxBvhPrimitives) {
    throw InternalError(fmt::format("a BVH over {} primitives; the maximum is {}", itemCount, kMaxBvhPrimitives));
  }
  if (options.maxLeafSize < 1) throw InternalError("a BVH with leaves of 0 primitives");
  if (!(options.traversalCost > 0 && options.intersectionCost > 0)) {
    throw InternalError(
        fmt::format("BVH costs {} and {}; both must be above 0", options.traversalCost, options.intersectionCost));
  }
  const std::uint32_t needed = levelsNeeded(itemCount, options.maxLeafSize);
  if (options.maxDepth < needed) {
    throw InternalError(
        fmt::format("a maximum BVH depth of {} for {} primitives and {} per leaf: at least {} is needed",
                    options.maxDepth, itemCount, options.maxLeafSize, needed));
  }
}

std::vector<BuildItem> makeItems(std::span<const Aabb> bounds) {
  std::vector<BuildItem> items;
  items.reserve(bounds.size());
  for (const Aabb& b : bounds) {
    requireProper(b, items.size(), "BVH");
    items.emplace_back(b, static_cast<std::uint32_t>(items.size()));
  }
  return items;
}

// A range of items to be built, `levels` steps above the depth limit.
struct Range {
  std::size_t first;
  std::size_t count;
  std::uint32_t levels;
  RangeSummary summary;
};

// The trunk of the BVH during the build: a branch either forks, or has its whole subtree in `nodes`, root first.
struct Branch {
  Aabb bounds;
  std::unique_ptr<std::array<Branch, 2>> fork;
  std::vector<BvhNode> nodes;
};

class BvhBuilder {
 public:
  BvhBuilder(std::span<const Aabb> bounds, const BvhOptions& options)
      : options_(options), items_(makeItems(bounds)), pool_(threadCount(options, bounds.size())) {}

  Bvh build() {
    grow(root_, {0, items_.size(), options_.maxDepth, summarize(items_)});
    pool_.wait();
    Bvh bvh;
    bvh.nodes.reserve(nodeCount_);
    bvh.nodes.emplace_back();
    append(root_, 0, bvh.nodes);
    bvh.primitiveIndices.reserve(items_.size());
    for (const BuildItem& item : items_) bvh.primitiveIndices.push_back(item.index());
    return bvh;
  }

 private:
  static std::uint32_t threadCount(const BvhOptions& options, std::size_t itemCount) {
    if (itemCount < 2 * kTaskItems) return 1;
    return threadCountFor(options.threads);
  }

  // Forks large ranges, with a task for each side; small ones become subtrees at once.
  void grow(Branch& branch, const Range& range) {
    branch.bounds = range.summary.bounds.toAabb();
    const auto halves = range.count < kTaskItems ? std::nullopt : divide(range);
    if (!halves) {
      branch.nodes.reserve(range.count);
      branch.nodes.emplace_back();
      growSubtree(branch.nodes, 0, range);
      nodeCount_ += branch.nodes.size();
      return;
    }
    nodeCount_ += 1;
    branch.fork = std::make_unique<std::array<Branch, 2>>();
    for (std::size_t side : {0, 1}) {
      pool_.submit([this, &child = (*branch.fork)[side], half = (*halves)[side]] { grow(child, half); });
    }
  }

  // The recursion ends at options_.maxDepth.
  void growSubtree(std::vector<BvhNode>& nodes, std::size_t slot, const Range& range) {
    const auto halves = divide(range);
    nodes[slot].bounds = range.summary.bounds.toAabb();
    if (!halves) {
      nodes[slot].first = static_cast<std::uint32_t>(range.first);
      nodes[slot].count = static_cast<std::uint32_t>(range.count);
      return;
    }
    const std::size_t children = nodes.size();
    nodes[slot].first = static_cast<std::uint32_t>(children);
    nodes.resize(children + 2);
    growSubtree(nodes, children, (*halves)[0]);
    growSubtree(nodes, children + 1, (*halves)[1]);
  }

  std::optional<std::array<Range, 2>> divide(const Range& range) {
    const auto items = std::span(items_).subspan(range.first, range.count);
    const auto split = splitRange(items, range.summary, range.levels, options_);
    if (!split) return std::nullopt;
    const std::size_t leftCount = split->leftCount;
    return {{Range{range.first, leftCount, range.levels - 1, split->sides[0]},
             Range{range.first + leftCount, range.count - leftCount, range.levels - 1, split->sides[1]}}};
  }

  // Puts the root of a branch into `slot` and its other nodes at the end, in the order of growSubtree().
  static void append(Branch& branch, std::size_t slot, std::vector<BvhNode>& out) {
    const std::size_t behind = out.size();
    if (branch.fork) {
      out[slot] = {branch.bounds, static_cast<std::uint32_t>(behind), 0};
      out.resize(behind + 2);
      append((*branch.fork)[0], behind, out);
      append((*branch.fork)[1], behind + 1, out);
      return;
    }
    const auto shift = static_cast<std::uint32_t>(behind - 1);
    for (BvhNode& node : branch.nodes) node.first += node.isLeaf() ? 0 : shift;
    out[slot] = branch.nodes.front();
    out.insert(out.end(), branch.nodes.begin() + 1, branch.nodes.end());
    branch.nodes = {};
  }

  const BvhOptions options_;
  std::vector<BuildItem> items_;
  Branch root_;
  std::atomic<std::size_t> nodeCount_ = 0;
  TaskPool pool_;  ///< last member: its threads end before the data on which they work
};

}  // namespace

Bvh buildBvh(std::span<const Aabb> bounds, const BvhOptions& options) {
  requireOptions(options, bounds.size());
  if (bounds.empty()) return {};
  return reinsert(BvhBuilder(bounds, options).build(), options);
}

}  // namespace candela::accel

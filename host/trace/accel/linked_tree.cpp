// Opens BVHs, moves their subtrees, and stores them in order again.
#include "host/trace/accel/linked_tree.h"

#include <algorithm>
#include <queue>
#include <tuple>
#include <utility>

namespace candela::accel {
namespace {

std::vector<std::uint32_t> heightsOf(const Bvh& bvh) {
  std::vector<std::uint32_t> heights(bvh.nodes.size(), 0);
  for (std::size_t i = bvh.nodes.size(); i-- > 0;) {
    const BvhNode& node = bvh.nodes[i];
    if (!node.isLeaf()) heights[i] = 1 + std::max(heights[node.first], heights[node.first + 1]);
  }
  return heights;
}

// Returns the end of the nodes below an interior node: the end of the deepest of the rightmost pairs.
std::uint32_t endBelow(const Bvh& bvh, std::uint32_t node) {
  std::uint32_t pair = bvh.nodes[node].first;
  for (;;) {
    const BvhNode& right = bvh.nodes[pair + 1];
    const BvhNode& last = right.isLeaf() ? bvh.nodes[pair] : right;
    if (last.isLeaf()) return pair + 2;
    pair = last.first;
  }
}

// Appends the subtree below `node` of the source to `out`, with its root in `slot`.
void append(const Bvh& source, std::uint32_t node, std::uint32_t slot, std::vector<BvhNode>& out) {
  const BvhNode& root = source.nodes[node];
  out[slot] = root;
  if (root.isLeaf()) return;
  const auto shift = static_cast<std::uint32_t>(out.size()) - root.first;  // modulo 2^32
  out[slot].first += shift;
  for (std::uint32_t i = root.first, end = endBelow(source, node); i < end; ++i) {
    out.push_back(source.nodes[i]);
    if (!out.back().isLeaf()) out.back().first += shift;
  }
}

}  // namespace

LinkedTree::LinkedTree(const Bvh& source, std::size_t nodeLimit) {
  if (source.nodes.size() <= nodeLimit) {
    openAll(source);
  } else {
    openLargest(source, nodeLimit);
  }
}

void LinkedTree::openAll(const Bvh& source) {
  nodes_ = source.nodes;
  heights_ = heightsOf(source);
  parents_.resize(nodes_.size() / 2);
  for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
    if (nodes_[i].isLeaf()) nodes_[i].first = i;
    put(i, nodes_[i], heights_[i]);
  }
}

void LinkedTree::openLargest(const Bvh& source, std::size_t nodeLimit) {
  const std::vector<std::uint32_t> heights = heightsOf(source);
  using Closed = std::tuple<double, std::uint32_t, std::uint32_t>;  // half area, index in the source, index here
  std::priority_queue<Closed> closed;
  const auto close = [&](std::uint32_t node, std::uint32_t index) {
    const BvhNode& origin = source.nodes[node];
    nodes_[index] = {origin.bounds, node, 1};
    heights_[index] = heights[node];
    if (!origin.isLeaf()) closed.emplace(origin.bounds.surfaceArea(), node, index);
  };
  nodes_.resize(1);
  heights_.resize(1);
  close(0, 0);
  while (!closed.empty() && nodes_.size() + 2 <= nodeLimit) {
    const auto [area, node, index] = closed.top();
    closed.pop();
    const auto pair = static_cast<std::uint32_t>(nodes_.size());
    nodes_.resize(pair + 2);
    heights_.resize(pair + 2);
    parents_.push_back(index);
    nodes_[index].first = pair;
    nodes_[index].count = 0;
    for (const std::uint32_t side : {0u, 1u}) close(source.nodes[node].first + side, pair + side);
  }
}

double LinkedTree::innerHalfArea() const {
  double sum = 0;
  for (const BvhNode& node : nodes_) sum += node.isLeaf() ? 0 : node.bounds.surfaceArea() / 2;
  return sum;
}

bool LinkedTree::mayMove(const SubtreeMove& move, std::uint32_t maxDepth) const {
  std::uint32_t depth = 0;
  for (std::uint32_t node = move.to; node != 0; node = parentOf(node), ++depth) {
    if (node == move.from) return false;
  }
  return depth + 1 + std::max(heights_[move.from], heights_[move.to]) <= maxDepth;
}

void LinkedTree::move(const SubtreeMove& move) {
  const std::uint32_t parent = parentOf(move.from), sibling = siblingOf(move.from);
  // The sibling replaces its parent, so that its own index becomes free for the node that gets a new sibling.
  put(parent, nodes_[sibling], heights_[sibling]);
  if (parent != 0) refit(parentOf(parent));
  put(sibling, nodes_[move.to], heights_[move.to]);
  put(move.to, {{}, std::min(move.from, sibling), 0}, 0);
  refit(move.to);
}

void LinkedTree::put(std::uint32_t index, const BvhNode& node, std::uint32_t height) {
  nodes_[index] = node;
  heights_[index] = height;
  if (!node.isLeaf()) parents_[(node.first - 1) / 2] = index;
}

// Updates boxes and heights from an interior node upwards, as far as they change.
void LinkedTree::refit(std::uint32_t node) {
  for (;;) {
    BvhNode& inner = nodes_[node];
    Aabb bounds = nodes_[inner.first].bounds;
    bounds.extend(nodes_[inner.first + 1].bounds);
    const std::uint32_t height = 1 + std::max(heights_[inner.first], heights_[inner.first + 1]);
    if (bounds == inner.bounds && height == heights_[node]) return;
    inner.bounds = bounds;
    heights_[node] = height;
    if (node == 0) return;
    node = parentOf(node);
  }
}

Bvh LinkedTree::layOut(const Bvh& source) const {
  Bvh result{{}, source.primitiveIndices};
  result.nodes.reserve(source.nodes.size());
  result.nodes.emplace_back();
  layOut(source, 0, 0, result.nodes);
  return result;
}

// The recursion ends at the depth that mayMove() ensures.
void LinkedTree::layOut(const Bvh& source, std::uint32_t node, std::uint32_t slot, std::vector<BvhNode>& out) const {
  const BvhNode& from = nodes_[node];
  if (from.isLeaf()) return append(source, from.first, slot, out);
  const auto children = static_cast<std::uint32_t>(out.size());
  out[slot] = {from.bounds, children, 0};
  out.resize(children + 2);
  layOut(source, from.first, children, out);
  layOut(source, from.first + 1, children + 1, out);
}

}  // namespace candela::accel

// Collapses a binary BVH into an 8-wide one.
#include "host/trace/accel/wide_bvh.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "host/base/errors.h"
#include "host/base/run_on_threads.h"
#include "host/trace/accel/block_packer.h"
#include "host/trace/accel/task_pool.h"
#include "host/trace/accel/wide_families.h"

namespace candela::accel {
namespace {

// Indices of binary nodes by position in an 8-wide node.
constexpr std::uint32_t kNobody = ~0u;
using Children = std::array<std::uint32_t, kWideChildren>;

struct Pending {
  std::uint32_t source;  ///< index in the binary BVH
  std::uint32_t target;  ///< index in the 8-wide BVH
  std::uint32_t depth;
};

// Below the top of the BVH, at least this many subtrees are collapsed independently of each other, by all threads.
constexpr std::size_t kSubtrees = 64;
constexpr std::size_t kFewNodes = 20000;  // below this number of nodes, one thread is faster than starting others

// Collapses the part of the BVH below one binary node.
class Collapser {
 public:
  Collapser(const Bvh& bvh, const WideFamilies& families, std::uint32_t root)
      : bvh_(bvh), families_(families), pending_{{root, 0, 0}} {
    wide_.nodes.resize(blocks_.end());
  }

  // Collapses level by level until at least this many subtrees are left.
  std::vector<Pending> runUntil(std::size_t count) {
    for (std::size_t next = 0;; ++next) {
      if (next == pending_.size() || pending_.size() - next >= count)
        return {pending_.begin() + static_cast<std::ptrdiff_t>(next), pending_.end()};
      collapse(Pending(pending_[next]));
    }
  }

  // Collapses everything, in depth-first order.
  void run() {
    while (!pending_.empty()) {
      const Pending next = pending_.back();
      pending_.pop_back();
      collapse(next);
    }
  }

  WideBvh take() { return std::move(wide_); }

 private:
  void collapse(const Pending& pending) {
    const Children children = arrange(familyOf(pending.source), bvh_.nodes[pending.source].bounds);
    std::array<Aabb, kWideChildren> boxes;
    WideNode node;
    node.firstPrimitive = static_cast<std::uint32_t>(wide_.primitiveIndices.size());
    for (std::uint32_t index = 0; index < kWideChildren; ++index) {
      if (children[index] == kNobody) continue;
      const BvhNode& child = bvh_.nodes[children[index]];
      boxes[index] = child.bounds;
      if (child.isLeaf()) {
        node.leafMask |= appendLeaf(child) << (3 * index);
      } else {
        node.innerMask |= static_cast<std::uint8_t>(1u << index);
      }
    }
    node.boxes = quantise(boxes);
    if (node.innerMask != 0) node.block = addBlock(children, node.innerMask, pending.depth + 1);
    wide_.nodes[pending.target] = node;
    wide_.depth = std::max(wide_.depth, pending.depth);
    ++wide_.nodeCount;
  }

  // If the root is a leaf, it becomes the only child of an 8-wide node.
  Family familyOf(std::uint32_t root) const {
    return bvh_.nodes[root].isLeaf() ? Family{{root}, 1} : families_.of(root);
  }

  // Repeatedly assigns the child and the free position that fit each other best: Ylitie et al., section 3.2, with a
  // greedy choice instead of an auction.
  Children arrange(const Family& family, const Aabb& bounds) const {
    std::array<glm::dvec3, kWideChildren> offsets;
    for (std::uint32_t i = 0; i < family.size; ++i) {
      const Aabb& box = bvh_.nodes[family.members[i]].bounds;
      offsets[i] = (glm::dvec3(box.min) - glm::dvec3(bounds.min)) + (glm::dvec3(box.max) - glm::dvec3(bounds.max));
    }
    Children children;
    children.fill(kNobody);
    std::array<bool, kWideChildren> placed{};
    for (std::uint32_t round = 0; round < family.size; ++round) {
      double bestGain = -std::numeric_limits<double>::infinity();
      std::uint32_t bestChild = 0, bestIndex = 0;
      for (std::uint32_t child = 0; child < family.size; ++child) {
        if (placed[child]) continue;
        for (std::uint32_t index = 0; index < kWideChildren; ++index) {
          const double gain = gainOf(offsets[child], index);
          if (children[index] != kNobody || gain <= bestGain) continue;
          bestGain = gain;
          bestChild = child;
          bestIndex = index;
        }
      }
      children[bestIndex] = family.members[bestChild];
      placed[bestChild] = true;
    }
    return children;
  }

  static double gainOf(const glm::dvec3& offset, std::uint32_t index) {
    return (index & 1 ? offset.x : -offset.x) + (index & 2 ? offset.y : -offset.y) + (index & 4 ? offset.z : -offset.z);
  }

  // Appends the primitives of the leaf. Returns their bits of a leaf mask.
  std::uint32_t appendLeaf(const BvhNode& leaf) {
    if (leaf.count > kMaxWideLeaf) {
      throw InternalError(
          fmt::format("a leaf of {} primitives; the maximum of an 8-wide BVH is {}", leaf.count, kMaxWideLeaf));
    }
    const auto first = bvh_.primitiveIndices.begin() + leaf.first;
    wide_.primitiveIndices.insert(wide_.primitiveIndices.end(), first, first + leaf.count);
    return (1u << leaf.count) - 1;
  }

  std::uint32_t addBlock(const Children& children, std::uint8_t innerMask, std::uint32_t depth) {
    const std::uint32_t block = blocks_.place(innerMask);
    wide_.nodes.resize(blocks_.end());
    for (std::uint32_t index = kWideChildren; index-- > 0;) {
      if ((innerMask >> index & 1) == 0) continue;
      pending_.push_back({children[index], block + index, depth});
    }
    return block;
  }

  const Bvh& bvh_;
  const WideFamilies& families_;
  WideBvh wide_;
  BlockPacker blocks_;
  std::vector<Pending> pending_;
};

// Adjusts a node of a subtree whose nodes other than the root are stored after `nodes` others, and whose primitives are
// stored after `primitives` others.
WideNode moved(WideNode node, std::size_t nodes, std::size_t primitives) {
  if (node.innerMask != 0) node.block += static_cast<std::uint32_t>(nodes) - 1;
  node.firstPrimitive += static_cast<std::uint32_t>(primitives);
  return node;
}

// `roots[i]` is the index for the root of `subtrees[i]`.
WideBvh join(WideBvh wide, std::span<const Pending> roots, std::span<const WideBvh> subtrees) {
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const WideBvh& part = subtrees[i];
    const std::size_t nodes = wide.nodes.size();
    const std::size_t primitives = wide.primitiveIndices.size();
    wide.nodes[roots[i].target] = moved(part.nodes.front(), nodes, primitives);
    for (std::size_t k = 1; k < part.nodes.size(); ++k) wide.nodes.push_back(moved(part.nodes[k], nodes, primitives));
    wide.primitiveIndices.insert(wide.primitiveIndices.end(), part.primitiveIndices.begin(),
                                 part.primitiveIndices.end());
    wide.depth = std::max(wide.depth, roots[i].depth + part.depth);
    wide.nodeCount += part.nodeCount;
  }
  if (wide.nodes.size() > kMaxWideNodes)
    throw InternalError(fmt::format("an 8-wide BVH of {} nodes", wide.nodes.size()));
  return wide;
}

}  // namespace

WideBvh collapse(const Bvh& bvh) {
  if (bvh.nodes.empty()) return {};
  const WideFamilies families(bvh);
  Collapser top(bvh, families, 0);
  const std::vector<Pending> roots = top.runUntil(kSubtrees);
  std::vector<WideBvh> subtrees(roots.size());
  TaskPool pool(bvh.nodes.size() < kFewNodes ? 1 : threadCountFor(0));
  for (std::size_t i = 0; i < roots.size(); ++i) {
    pool.submit([&, i] {
      Collapser collapser(bvh, families, roots[i].source);
      collapser.run();
      subtrees[i] = collapser.take();
    });
  }
  pool.wait();
  return join(top.take(), roots, subtrees);
}

}  // namespace candela::accel

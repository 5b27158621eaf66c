// Pairs of boxes that overlap, by a binary tree over the boxes.
#pragma once
#include <atomic>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace candela::scene {

/// A limit of the work of several threads. Whether the work is within it does not depend on their order.
class WorkLimit {
 public:
  /// The work counts for `whole`, too, if it is not null.
  explicit WorkLimit(std::uint64_t limit, WorkLimit* whole = nullptr) : limit_(limit), whole_(whole) {}

  void add(std::uint64_t work) {
    done_.fetch_add(work, std::memory_order_relaxed);
    if (whole_) whole_->add(work);
  }
  bool isExceeded() const { return done_.load(std::memory_order_relaxed) > limit_ || (whole_ && whole_->isExceeded()); }

 private:
  std::uint64_t limit_;
  WorkLimit* whole_;
  std::atomic<std::uint64_t> done_ = 0;
};

/// The closed box of an item.
struct ItemBox {
  glm::vec3 low, high;
  std::uint32_t item = 0;
};

/// A tree that halves the boxes at the middle of their centres, until at most kLeafSize are left in each part.
class BoxTree {
 public:
  /// Two different items whose boxes overlap, the higher one first.
  using Pair = std::pair<std::uint32_t, std::uint32_t>;
  /// Receives pairs; `thread` is below the number of threads.
  using PairVisitor = std::function<void(std::uint32_t thread, std::span<const Pair> pairs)>;
  using BoxTest = std::function<bool(const glm::vec3& low, const glm::vec3& high)>;
  /// Replaces a box of the tree by one in the space in which it is compared with those of another tree.
  using BoxMap = std::function<void(glm::vec3& low, glm::vec3& high)>;

  BoxTree(std::vector<ItemBox> boxes, std::uint32_t threadCount);

  /// Visits all pairs, each once, in no particular order, on several threads. Ends early when the limit is exceeded. A
  /// comparison of two boxes is a unit of work; a visitor adds its own.
  void visitPairs(WorkLimit& limit, const PairVisitor& visit) const;

  /// Visits the items whose box, and all boxes around it, pass the test. Each test is eight units of work.
  void visitItems(WorkLimit& limit, const BoxTest& passes, const std::function<void(std::uint32_t)>& visit) const;

  /// Visits each pair of an item of this tree and one of another tree whose boxes overlap once both are mapped, and so
  /// are all boxes around them. A comparison of two boxes is a unit of work; a visitor adds its own.
  void visitPairsWith(const BoxTree& other, const BoxMap& ownMap, const BoxMap& otherMap, WorkLimit& limit,
                      const std::function<void(std::uint32_t own, std::uint32_t other)>& visit) const;

  std::size_t size() const { return boxes_.size(); }
  /// Returns the box around all items, of which there must be one at least.
  ItemBox bounds() const { return {nodes_[0].low, nodes_[0].high}; }

 private:
  static constexpr std::uint32_t kLeafSize = 6;

  /// Has no initial values, so that memory of nodes that are not used is never touched.
  struct Node {
    glm::vec3 low, high;
    std::uint32_t begin, end;  ///< into boxes_
    std::uint32_t children;    ///< index of the first of two; 0: a leaf
    bool isLeaf() const { return children == 0; }
    std::uint32_t count() const { return end - begin; }
  };
  /// Two nodes whose items are compared with each other, or twice the same node.
  struct Task {
    std::uint32_t a, b;
  };
  class Search;
  class MappedSearch;

  void buildSubtree(std::uint32_t root);
  void split(std::uint32_t index);
  void bound(std::uint32_t index);
  std::vector<Task> tasks() const;

  std::uint32_t threadCount_;
  std::vector<ItemBox> boxes_;
  std::unique_ptr<Node[]> nodes_;
  std::atomic<std::uint32_t> nodeCount_ = 0;
};

}  // namespace candela::scene

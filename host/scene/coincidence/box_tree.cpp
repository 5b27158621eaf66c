// Builds the tree in place, and compares its nodes with each other from the root down.
#include "host/scene/coincidence/box_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "host/base/run_on_threads.h"

namespace candela::scene {
namespace {

using glm::vec3;

constexpr std::size_t kSubtreeSize = 4096;  // items of a subtree that one thread builds
constexpr std::uint64_t kMaxUncountedWork = 4096;

// All six comparisons are cheaper than branches that cannot be predicted.
template <class A, class B>
bool overlap(const A& a, const B& b) {
  return ((a.low.x <= b.high.x) & (b.low.x <= a.high.x) & (a.low.y <= b.high.y) & (b.low.y <= a.high.y) &
          (a.low.z <= b.high.z) & (b.low.z <= a.high.z)) != 0;
}

}  // namespace

// Compares nodes on one thread, and passes pairs on in blocks.
class BoxTree::Search {
 public:
  Search(const BoxTree& tree, std::uint32_t thread, WorkLimit& limit, const PairVisitor& visit)
      : tree_(tree), thread_(thread), limit_(limit), visit_(visit) {}

  void run(const Task& task) {
    if (task.a == task.b) {
      within(task.a);
    } else {
      between(task.a, task.b);
    }
  }

  void flush() {
    limit_.add(work_);
    work_ = 0;
    if (count_ > 0) visit_(thread_, std::span(pairs_).first(count_));
    count_ = 0;
  }

 private:
  void within(std::uint32_t index) {
    const Node& node = tree_.nodes_[index];
    if (!node.isLeaf()) {
      within(node.children);
      within(node.children + 1);
      between(node.children, node.children + 1);
      return;
    }
    for (std::uint32_t i = node.begin + 1; i < node.end; ++i) compare(tree_.boxes_[i], node.begin, i);
  }

  void between(std::uint32_t indexOfA, std::uint32_t indexOfB) {
    const Node& a = tree_.nodes_[indexOfA];
    const Node& b = tree_.nodes_[indexOfB];
    ++work_;
    if (!overlap(a, b) || limit_.isExceeded()) return;
    if (a.isLeaf() && b.isLeaf()) {
      for (std::uint32_t i = a.begin; i < a.end; ++i) {
        if (overlap(tree_.boxes_[i], b)) compare(tree_.boxes_[i], b.begin, b.end);
      }
      work_ += a.count();
    } else if (b.isLeaf() || (!a.isLeaf() && a.count() >= b.count())) {
      between(a.children, indexOfB);
      between(a.children + 1, indexOfB);
    } else {
      between(indexOfA, b.children);
      between(indexOfA, b.children + 1);
    }
  }

  void compare(const ItemBox& box, std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t i = begin; i < end; ++i) {
      const ItemBox& other = tree_.boxes_[i];
      if (overlap(box, other)) pairs_[count_++] = std::minmax(box.item, other.item, std::greater());
    }
    work_ += end - begin;
    if (count_ + kLeafSize > pairs_.size() || work_ > kMaxUncountedWork) flush();
  }

  const BoxTree& tree_;
  std::uint32_t thread_;
  WorkLimit& limit_;
  const PairVisitor& visit_;
  std::array<Pair, 512> pairs_;
  std::size_t count_ = 0;
  std::uint64_t work_ = 0;
};

// Compares nodes and items of two trees in the space to which their boxes are mapped.
class BoxTree::MappedSearch {
 public:
  using Visitor = std::function<void(std::uint32_t, std::uint32_t)>;

  MappedSearch(WorkLimit& limit, const Visitor& visit) : limit_(limit), visit_(visit) {}
  ~MappedSearch() { limit_.add(work_); }

  void run(const BoxTree& a, const BoxMap& mapOfA, const BoxTree& b, const BoxMap& mapOfB) {
    between(Part(a, mapOfA), Part(b, mapOfB));
  }

 private:
  // A node or an item of a tree. The parts of a leaf are its items.
  class Part {
   public:
    Part(const BoxTree& tree, const BoxMap& map) : Part(tree, map, &tree.nodes_[0], tree.nodes_[0], 0) {}

    const ItemBox& box() const { return box_; }
    bool isItem() const { return !node_; }
    // The longest side, by which the larger one of two parts is divided; that of items is less than any other.
    float size() const {
      const glm::vec3 sides = box_.high - box_.low;
      return isItem() ? -1 : std::max({sides.x, sides.y, sides.z});
    }
    template <class Visit>
    void forEachPart(const Visit& visit) const {
      if (node_->isLeaf()) {
        for (std::uint32_t i = node_->begin; i < node_->end; ++i) {
          visit(Part(*tree_, *map_, nullptr, tree_->boxes_[i], tree_->boxes_[i].item));
        }
      } else {
        for (const std::uint32_t child : {node_->children, node_->children + 1}) {
          visit(Part(*tree_, *map_, &tree_->nodes_[child], tree_->nodes_[child], 0));
        }
      }
    }

   private:
    template <class Boxed>
    Part(const BoxTree& tree, const BoxMap& map, const Node* node, const Boxed& box, std::uint32_t item)
        : tree_(&tree), map_(&map), node_(node), box_{box.low, box.high, item} {
      map(box_.low, box_.high);
    }

    const BoxTree* tree_;
    const BoxMap* map_;
    const Node* node_;  // null: an item
    ItemBox box_;
  };

  void between(const Part& a, const Part& b) {
    if (++work_ > kMaxUncountedWork) limit_.add(std::exchange(work_, 0));
    if (!overlap(a.box(), b.box()) || limit_.isExceeded()) return;
    if (a.isItem() && b.isItem()) {
      visit_(a.box().item, b.box().item);
    } else if (a.size() >= b.size()) {
      a.forEachPart([&](const Part& part) { between(part, b); });
    } else {
      b.forEachPart([&](const Part& part) { between(a, part); });
    }
  }

  WorkLimit& limit_;
  const Visitor& visit_;
  std::uint64_t work_ = 0;
};

BoxTree::BoxTree(std::vector<ItemBox> boxes, std::uint32_t threadCount)
    : threadCount_(threadCount), boxes_(std::move(boxes)) {
  if (boxes_.empty()) return;
  // A split leaves at least two boxes on each side, so that there are fewer nodes than boxes, but for the root.
  nodes_ = std::make_unique_for_overwrite<Node[]>(boxes_.size() + 1);
  nodes_[0].begin = 0, nodes_[0].end = static_cast<std::uint32_t>(boxes_.size()), nodes_[0].children = 0;
  nodeCount_ = 1;
  std::vector<std::uint32_t> top{0}, subtrees;
  for (std::size_t i = 0; i < top.size(); ++i) {
    const std::uint32_t index = top[i];
    if (nodes_[index].count() <= kSubtreeSize) {
      subtrees.push_back(index);
    } else {
      split(index);
      top.insert(top.end(), {nodes_[index].children, nodes_[index].children + 1});
    }
  }
  forEachOnThreads(threadCount_, subtrees.size(), [&](std::uint32_t, std::size_t i) { buildSubtree(subtrees[i]); });
  for (std::size_t i = top.size(); i-- > 0;) {
    if (nodes_[top[i]].count() > kSubtreeSize) bound(top[i]);
  }
}

void BoxTree::buildSubtree(std::uint32_t root) {
  if (nodes_[root].count() > kLeafSize) {
    split(root);
    buildSubtree(nodes_[root].children);
    buildSubtree(nodes_[root].children + 1);
  }
  bound(root);
}

// Halves the range of the centres along its longest axis, or the number of boxes where that would leave few on one
// side.
void BoxTree::split(std::uint32_t index) {
  Node& node = nodes_[index];
  const auto begin = boxes_.begin() + node.begin, end = boxes_.begin() + node.end;
  vec3 low(INFINITY), high(-INFINITY);
  for (auto box = begin; box != end; ++box) {
    const vec3 centre = 0.5f * box->low + 0.5f * box->high;
    low = glm::min(low, centre), high = glm::max(high, centre);
  }
  const vec3 extent = high - low;
  const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
  const auto centreOf = [axis](const ItemBox& box) { return 0.5f * box.low[axis] + 0.5f * box.high[axis]; };
  const float middle = 0.5f * low[axis] + 0.5f * high[axis];
  auto upper = std::partition(begin, end, [&](const ItemBox& box) { return centreOf(box) < middle; });
  const std::ptrdiff_t minimum = (end - begin) / 64 + 2;
  if (upper - begin < minimum || end - upper < minimum) {
    upper = begin + (end - begin) / 2;
    std::nth_element(begin, upper, end, [&](const ItemBox& a, const ItemBox& b) { return centreOf(a) < centreOf(b); });
  }
  node.children = nodeCount_.fetch_add(2, std::memory_order_relaxed);
  const auto at = static_cast<std::uint32_t>(upper - boxes_.begin());
  Node* const children = &nodes_[node.children];
  children[0].begin = node.begin, children[0].end = at, children[0].children = 0;
  children[1].begin = at, children[1].end = node.end, children[1].children = 0;
}

void BoxTree::bound(std::uint32_t index) {
  Node& node = nodes_[index];
  node.low = vec3(INFINITY), node.high = vec3(-INFINITY);
  const auto include = [&](const auto& box) {
    node.low = glm::min(node.low, box.low), node.high = glm::max(node.high, box.high);
  };
  if (node.isLeaf()) {
    std::for_each(boxes_.begin() + node.begin, boxes_.begin() + node.end, include);
  } else {
    include(nodes_[node.children]), include(nodes_[node.children + 1]);
  }
}

// Divides the comparison of the root with itself into tasks of few items on either side, but not into too many tasks.
std::vector<BoxTree::Task> BoxTree::tasks() const {
  const std::size_t maxSize = std::max(kSubtreeSize, boxes_.size() / 256);
  std::vector<Task> open{{0, 0}}, small;
  while (!open.empty()) {
    const Task task = open.back();
    open.pop_back();
    const Node& a = nodes_[task.a];
    const Node& b = nodes_[task.b];
    if (task.a != task.b && !overlap(a, b)) continue;
    if (std::max(a.count(), b.count()) <= maxSize) {
      small.push_back(task);
    } else if (task.a == task.b) {
      open.insert(open.end(),
                  {{a.children, a.children}, {a.children + 1, a.children + 1}, {a.children, a.children + 1}});
    } else if (a.count() >= b.count()) {
      open.insert(open.end(), {{a.children, task.b}, {a.children + 1, task.b}});
    } else {
      open.insert(open.end(), {{task.a, b.children}, {task.a, b.children + 1}});
    }
  }
  return small;
}

void BoxTree::visitPairs(WorkLimit& limit, const PairVisitor& visit) const {
  if (boxes_.empty()) return;
  const std::vector<Task> list = tasks();
  forEachOnThreads(threadCount_, list.size(), [&](std::uint32_t thread, std::size_t i) {
    if (limit.isExceeded()) return;
    Search search(*this, thread, limit, visit);
    search.run(list[i]);
    search.flush();
  });
}

void BoxTree::visitItems(WorkLimit& limit, const BoxTest& passes,
                         const std::function<void(std::uint32_t)>& visit) const {
  std::vector<std::uint32_t> open;
  if (!boxes_.empty()) open.push_back(0);
  std::uint64_t work = 0;
  while (!open.empty() && !limit.isExceeded()) {
    const Node& node = nodes_[open.back()];
    open.pop_back();
    ++work;
    if (!passes(node.low, node.high)) continue;
    if (!node.isLeaf()) {
      open.insert(open.end(), {node.children, node.children + 1});
      continue;
    }
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
      if (passes(boxes_[i].low, boxes_[i].high)) visit(boxes_[i].item);
    }
    work += node.count();
  }
  limit.add(8 * work);
}

void BoxTree::visitPairsWith(const BoxTree& other, const BoxMap& ownMap, const BoxMap& otherMap, WorkLimit& limit,
                             const std::function<void(std::uint32_t own, std::uint32_t other)>& visit) const {
  if (boxes_.empty() || other.boxes_.empty()) return;
  MappedSearch(limit, visit).run(*this, ownMap, other, otherMap);
}

}  // namespace candela::scene

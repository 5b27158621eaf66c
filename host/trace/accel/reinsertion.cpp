// Searches for better positions of subtrees, pass by pass.
#include "host/trace/accel/reinsertion.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "host/base/run_on_threads.h"
#include "host/trace/accel/linked_tree.h"
#include "host/trace/accel/task_pool.h"

namespace candela::accel {
namespace {

// Nearly all of the gain comes from the nodes with the largest surface areas, where the search is cheap.
constexpr std::size_t kTrunkNodes = 2048;
constexpr int kMaxPasses = 8;
constexpr double kMinGainOfPass = 1e-3;  // fraction of the sum of half areas; a pass with a smaller gain is the last
// If the gain within the trunk is smaller, the BVH is not copied.
constexpr double kMinGainOfTrunk = 1e-2;
constexpr std::size_t kTaskNodes = 1024;

double halfArea(const glm::vec3& min, const glm::vec3& max) {
  const glm::vec3 extent = max - min;
  const double x = extent.x, y = extent.y, z = extent.z;
  return x * y + (x + y) * z;
}
double halfArea(const Aabb& box) { return halfArea(box.min, box.max); }
double halfAreaOfBoth(const Aabb& a, const Aabb& b) { return halfArea(glm::min(a.min, b.min), glm::max(a.max, b.max)); }

// Finds the best position for one subtree at a time, by branch and bound.
class Search {
 public:
  explicit Search(const LinkedTree& tree) : tree_(tree) {}

  // Climbs from the parent of the subtree, which is removed, to the root. The remaining ancestors shrink to `rest`.
  SubtreeMove bestMove(std::uint32_t from) {
    const std::vector<BvhNode>& nodes = tree_.nodes();
    box_ = nodes[from].bounds;
    halfArea_ = halfArea(box_);
    best_ = {.from = from};
    std::uint32_t node = tree_.parentOf(from);
    double saved = halfArea(nodes[node].bounds);
    Aabb rest = nodes[LinkedTree::siblingOf(from)].bounds;
    tryBelow(LinkedTree::siblingOf(from), saved);
    for (; node != 0; node = tree_.parentOf(node)) {
      const std::uint32_t side = LinkedTree::siblingOf(node);
      offer(node, saved - halfArea(nodes[node].bounds));
      tryBelow(side, saved);
      rest.extend(nodes[side].bounds);
      saved += halfArea(nodes[tree_.parentOf(node)].bounds) - halfArea(rest);
    }
    offer(0, saved - halfArea(nodes[0].bounds));
    return best_;
  }

 private:
  struct Visit {
    std::uint32_t node;
    double saved;  // half areas that are removed, minus the growth of those above the node
  };

  void offer(std::uint32_t to, double gain) {
    if (gain <= best_.gain) return;
    best_.to = to;
    best_.gain = gain;
  }

  // The new interior node alone costs the half area of the subtree's own box.
  bool isHopeless(double saved) const { return saved - halfArea_ <= best_.gain; }

  void tryBelow(std::uint32_t root, double saved) {
    stack_.assign(1, {root, saved});
    while (!stack_.empty()) {
      const Visit visit = stack_.back();
      stack_.pop_back();
      if (isHopeless(visit.saved)) continue;
      const BvhNode& node = tree_.nodes()[visit.node];
      const double gain = visit.saved - halfAreaOfBoth(node.bounds, box_);
      offer(visit.node, gain);
      const double below = gain + halfArea(node.bounds);
      if (node.isLeaf() || isHopeless(below)) continue;
      stack_.push_back({node.first + 1, below});
      stack_.push_back({node.first, below});
    }
  }

  const LinkedTree& tree_;
  Aabb box_;
  double halfArea_ = 0;
  SubtreeMove best_;
  std::vector<Visit> stack_;
};

// Returns the best moves of all subtrees in descending order of gain.
std::vector<SubtreeMove> bestMoves(const LinkedTree& tree, TaskPool& pool) {
  std::vector<SubtreeMove> moves(tree.nodes().size() - 1);
  for (std::size_t first = 0; first < moves.size(); first += kTaskNodes) {
    pool.submit([&tree, &moves, first] {
      Search search(tree);
      const std::size_t end = std::min(moves.size(), first + kTaskNodes);
      for (std::size_t i = first; i < end; ++i) moves[i] = search.bestMove(static_cast<std::uint32_t>(i + 1));
    });
  }
  pool.wait();
  std::erase_if(moves, [](const SubtreeMove& move) { return move.to == SubtreeMove::kNowhere; });
  std::sort(moves.begin(), moves.end(), [](const SubtreeMove& a, const SubtreeMove& b) {
    return std::pair(-a.gain, a.from) < std::pair(-b.gain, b.from);
  });
  return moves;
}

// Omits moves whose surroundings have been changed by other moves: they would not have the computed gain.
void apply(const std::vector<SubtreeMove>& moves, std::uint32_t maxDepth, LinkedTree& tree) {
  std::vector<bool> changed(tree.nodes().size(), false);
  for (const SubtreeMove& move : moves) {
    const std::uint32_t around[] = {move.from, move.to, tree.parentOf(move.from), LinkedTree::siblingOf(move.from)};
    const bool isStale = std::any_of(std::begin(around), std::end(around), [&](std::uint32_t i) { return changed[i]; });
    if (isStale || !tree.mayMove(move, maxDepth)) continue;
    for (const std::uint32_t node : around) changed[node] = true;
    tree.move(move);
  }
}

Bvh reinsertAmong(Bvh bvh, std::size_t nodeLimit, double minGain, const BvhOptions& options) {
  LinkedTree tree(bvh, nodeLimit);
  if (tree.nodes().size() < 5) return bvh;
  TaskPool pool(tree.nodes().size() < 2 * kTaskNodes ? 1 : threadCountFor(options.threads));
  const double start = tree.innerHalfArea();
  double sum = start;
  for (int pass = 0; pass < kMaxPasses; ++pass) {
    const double before = sum;
    apply(bestMoves(tree, pool), options.maxDepth, tree);
    sum = tree.innerHalfArea();
    if (sum >= (1 - kMinGainOfPass) * before) break;
  }
  // Moves of one pass that affect each other might even increase the cost.
  return sum < (1 - minGain) * start ? tree.layOut(bvh) : std::move(bvh);
}

}  // namespace

Bvh reinsert(Bvh bvh, const BvhOptions& options) {
  if (options.reinsertion == Reinsertion::none) return bvh;
  bvh = reinsertAmong(std::move(bvh), kTrunkNodes, kMinGainOfTrunk, options);
  if (options.reinsertion == Reinsertion::trunk) return bvh;
  return reinsertAmong(std::move(bvh), std::numeric_limits<std::size_t>::max(), 0, options);
}

}  // namespace candela::accel

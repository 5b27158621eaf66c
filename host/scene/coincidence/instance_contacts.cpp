// Searches each mesh once, and pairs of instances where their boxes overlap, down the trees of both meshes.
#include "host/scene/coincidence/instance_contacts.h"

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <mutex>
#include <optional>

#include "host/base/run_on_threads.h"
#include "host/scene/coincidence/coincidence.h"
#include "host/scene/coincidence/placed_surface.h"

namespace candela::scene {
namespace {

using Pair = InstanceContacts::Pair;

// A comparison of two boxes is a unit of work.
constexpr std::uint64_t kMaxInstanceWork = 1u << 29;   // between instances
constexpr std::uint64_t kMaxWorkPerSurface = 1u << 9;  // within a mesh, and of a pair of instances
constexpr std::uint64_t kWorkOfPlacedTest = 32;        // of two surfaces
constexpr std::uint64_t kMaxTestsPerSurface = 16;      // of triangles of a mesh in its instances

// Triangles that instances share, in a tree in the space of their mesh.
struct SharedTriangles {
  std::vector<std::uint32_t> runs;  // one of each placement, in the order of the scene
  std::uint32_t firstNumber;        // in StoredPrimitives
  PlacedTolerance tolerance;
  std::unique_ptr<BoxTree> tree;  // items: indices from the first triangle
};

bool isCopy(const FlatSurface& a, const FlatSurface& b) {
  return a.cornerCount == 3 && b.cornerCount == 3 &&
         std::is_permutation(a.corners.begin(), a.corners.begin() + 3, b.corners.begin());
}

class InstanceSearch {
 public:
  InstanceSearch(const Scene& scene, const StoredPrimitives& stored, const FlatSurfaces& unplaced,
                 const BoxTree& unplacedTree, std::uint32_t threadCount)
      : scene_(scene),
        runs_(scene.primitives.runs()),
        unplaced_(unplaced),
        unplacedTree_(unplacedTree),
        threadCount_(threadCount),
        found_(threadCount) {
    result_.reaches.resize(runs_.size());
    sharedOf_.resize(runs_.size());
    groupRuns(stored);
    for (SharedTriangles& shared : shared_) searchWithin(shared, buildTree(shared));
  }

  InstanceContacts take() && {
    const std::vector<Pair> pairs = overlappingRuns();
    forEachOnThreads(threadCount_, pairs.size(),
                     [&](std::uint32_t thread, std::size_t i) { compareRuns(pairs[i], found_[thread]); });
    comparePlanes();
    result_.truncated = limit_.isExceeded();
    for (const Found& found : found_) {
      if (result_.truncated) break;
      result_.copies.insert(result_.copies.end(), found.copies.begin(), found.copies.end());
      result_.overlaps.insert(result_.overlaps.end(), found.overlaps.begin(), found.overlaps.end());
      result_.unsearched.insert(result_.unsearched.end(), found.unsearched.begin(), found.unsearched.end());
    }
    if (result_.truncated) result_.copies.clear(), result_.overlaps.clear(), result_.uncertain.clear();
    for (std::vector<Pair>* const list : {&result_.copies, &result_.overlaps, &result_.unsearched}) {
      std::ranges::sort(*list);
      list->erase(std::unique(list->begin(), list->end()), list->end());
    }
    return std::move(result_);
  }

 private:
  // Contacts that one thread finds.
  struct Found {
    std::vector<Pair> copies, overlaps, unsearched;
  };

  const Placement& placementOf(std::uint32_t run) const { return scene_.placements[runs_[run].start.placement]; }
  const SharedTriangles& sharedOf(std::uint32_t run) const { return shared_[sharedOf_[run]]; }

  Triangle triangleIn(std::uint32_t run, std::uint32_t index, bool isPlaced) const {
    Primitive primitive = runs_[run].at(runs_[run].first + index);
    if (!isPlaced) primitive.placement = Primitive::kUnplaced;
    return triangleOf(scene_, primitive);
  }

  // Returns a triangle as it is placed; nothing if it has no area.
  std::optional<FlatSurface> placedSurface(std::uint32_t run, std::uint32_t index) const {
    FlatSurface surface;
    const std::size_t count = storeFlatParts(Shape(triangleIn(run, index, true)), runs_[run].first + index,
                                             std::span(&surface, 1));
    return count > 0 ? std::optional(surface) : std::nullopt;
  }

  void groupRuns(const StoredPrimitives& stored) {
    std::map<std::uint32_t, std::size_t> known;
    std::map<std::pair<std::size_t, std::array<float, 12>>, std::uint32_t> firstOfPlacement;
    for (std::uint32_t run = 0; run < runs_.size(); ++run) {
      if (!runs_[run].start.isPlaced()) continue;
      const auto [shared, isNew] = known.try_emplace(stored.firstOf(run), shared_.size());
      if (isNew) shared_.push_back({{}, stored.firstOf(run), {}, nullptr});
      sharedOf_[run] = shared->second;
      std::array<float, 12> key;
      for (std::size_t i = 0; i < key.size(); ++i) key[i] = placementOf(run).points[i / 4][static_cast<int>(i % 4)];
      const auto [first, isOther] = firstOfPlacement.try_emplace({shared->second, key}, run);
      if (isOther) {
        shared_[shared->second].runs.push_back(run);
      } else {
        result_.copiedRuns.emplace_back(first->second, run);
      }
    }
  }

  // Returns the triangles in the space of their mesh. Those that have no area in any instance are not in the tree.
  std::vector<MeshTriangle> buildTree(SharedTriangles& shared) {
    const std::uint32_t first = shared.runs.front();
    std::vector<MeshTriangle> triangles(scene_.primitives.countOf(runs_[first]));
    std::vector<ItemBox> boxes;
    ItemBox whole{glm::vec3(INFINITY), glm::vec3(-INFINITY)};
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
      const std::optional<MeshTriangle> triangle = meshTriangleOf(triangleIn(first, i, false));
      if (!triangle) continue;
      triangles[i] = *triangle;
      const auto& [a, b, c] = triangle->corners;
      boxes.push_back({glm::min(glm::min(a, b), c), glm::max(glm::max(a, b), c), i});
      whole.low = glm::min(whole.low, boxes.back().low), whole.high = glm::max(whole.high, boxes.back().high);
    }
    for (std::size_t i = 0; !boxes.empty() && i < shared.runs.size(); ++i) {
      shared.tolerance.include(toleranceOf(placementOf(shared.runs[i]), whole.low, whole.high));
    }
    const auto pad = static_cast<float>(shared.tolerance.plane + shared.tolerance.vertex);
    for (ItemBox& box : boxes) box.low -= pad, box.high += pad;
    shared.tree = std::make_unique<BoxTree>(std::move(boxes), threadCount_);
    return triangles;
  }

  // Finds triangles of one mesh that coincide in some instance: those that may, and of these, where they are few, those
  // that do.
  void searchWithin(const SharedTriangles& shared, std::span<const MeshTriangle> triangles) {
    std::vector<std::vector<BoxTree::Pair>> candidates(threadCount_);
    WorkLimit limit(kMaxWorkPerSurface * shared.tree->size());
    shared.tree->visitPairs(limit, [&](std::uint32_t thread, std::span<const BoxTree::Pair> pairs) {
      for (const auto& pair : pairs) {
        if (!mayCoincide(triangles[pair.second], triangles[pair.first], shared.tolerance)) continue;
        candidates[thread].push_back(pair);
      }
      limit.add(kWorkOfPlacedTest * pairs.size());
    });
    if (limit.isExceeded()) {
      result_.unsearched.emplace_back(shared.runs.front(), shared.runs.front());
      return;
    }
    std::vector<BoxTree::Pair> all;
    for (const auto& list : candidates) all.insert(all.end(), list.begin(), list.end());
    if (all.size() * shared.runs.size() > kMaxTestsPerSurface * (shared.tree->size() + shared.runs.size())) {
      for (const auto& [a, b] : all) {
        result_.uncertain.insert(result_.uncertain.end(), {shared.firstNumber + a, shared.firstNumber + b});
      }
      return;
    }
    forEachOnThreads(threadCount_, all.size(), [&](std::uint32_t thread, std::size_t i) {
      for (const std::uint32_t run : shared.runs) {
        if (compare(placedSurface(run, all[i].second), placedSurface(run, all[i].first), found_[thread])) break;
      }
    });
  }

  bool compare(const std::optional<FlatSurface>& a, const std::optional<FlatSurface>& b, Found& found) const {
    if (!a || !b) return false;
    const bool areCopies = isCopy(*a, *b);
    if (!areCopies && !overlapInPlane(*a, *b)) return false;
    (areCopies ? found.copies : found.overlaps).push_back(std::minmax(a->primitive, b->primitive));
    return true;
  }

  // Returns the pairs of instances whose boxes overlap, and those of kUnplacedRuns and an instance.
  std::vector<Pair> overlappingRuns() {
    std::vector<ItemBox> boxes;
    std::vector<Pair> pairs;
    for (const SharedTriangles& shared : shared_) {
      if (shared.tree->size() == 0) continue;
      for (const std::uint32_t run : shared.runs) {
        ItemBox box = shared.tree->bounds();
        BoxPlacement{placementOf(run)}(box.low, box.high);
        box.item = run;
        result_.reaches[run] = reachOf(std::array{box.low, box.high});
        boxes.push_back(box);
        pairs.emplace_back(kUnplacedRuns, run);
      }
    }
    for (const auto& [first, run] : result_.copiedRuns) result_.reaches[run] = result_.reaches[first];
    std::mutex mutex;
    BoxTree(std::move(boxes), threadCount_)
        .visitPairs(limit_, [&](std::uint32_t, std::span<const BoxTree::Pair> found) {
          const std::lock_guard lock(mutex);
          pairs.insert(pairs.end(), found.begin(), found.end());
        });
    return pairs;
  }

  BoxTree::BoxMap mapOf(std::uint32_t run) const {
    if (run == kUnplacedRuns) return [](glm::vec3&, glm::vec3&) {};
    return BoxPlacement(placementOf(run));
  }

  void compareRuns(const Pair& runs, Found& found) {
    const std::uint32_t other = runs.first, own = runs.second;  // Clang 14 captures no structured bindings
    const BoxTree& tree = *sharedOf(own).tree;
    const BoxTree& otherTree = other == kUnplacedRuns ? unplacedTree_ : *sharedOf(other).tree;
    WorkLimit limit(kMaxWorkPerSurface * (tree.size() + otherTree.size()), &limit_);
    Found contacts;
    tree.visitPairsWith(otherTree, mapOf(own), mapOf(other), limit, [&](std::uint32_t a, std::uint32_t b) {
      compare(placedSurface(own, a), other == kUnplacedRuns ? unplaced_[b] : placedSurface(other, b), contacts);
      limit.add(kWorkOfPlacedTest);
    });
    if (limit.isExceeded()) {
      found.unsearched.push_back(runs);
      return;
    }
    found.copies.insert(found.copies.end(), contacts.copies.begin(), contacts.copies.end());
    found.overlaps.insert(found.overlaps.end(), contacts.overlaps.begin(), contacts.overlaps.end());
  }

  void comparePlanes() {
    const std::span<const FlatSurface> planes = unplaced_.infinite();
    forEachOnThreads(threadCount_, planes.size(), [&](std::uint32_t thread, std::size_t i) {
      for (const SharedTriangles& shared : shared_) {
        for (const std::uint32_t run : shared.runs) {
          const BoxPlacement place(placementOf(run));
          const auto passes = [&](glm::vec3 low, glm::vec3 high) {
            place(low, high);
            return mayLieIn(planes[i], low, high);
          };
          shared.tree->visitItems(limit_, passes, [&](std::uint32_t item) {
            compare(placedSurface(run, item), planes[i], found_[thread]);
            limit_.add(kWorkOfPlacedTest);
          });
        }
      }
    });
  }

  const Scene& scene_;
  std::span<const PrimitiveRun> runs_;
  const FlatSurfaces& unplaced_;
  const BoxTree& unplacedTree_;
  std::uint32_t threadCount_;
  std::vector<SharedTriangles> shared_;
  std::vector<std::size_t> sharedOf_;  // by run
  WorkLimit limit_{kMaxInstanceWork};
  std::vector<Found> found_;  // by thread
  InstanceContacts result_;
};

}  // namespace

InstanceContacts findInstanceContacts(const Scene& scene, const StoredPrimitives& stored, const FlatSurfaces& unplaced,
                                      const BoxTree& unplacedTree, std::uint32_t threadCount) {
  return InstanceSearch(scene, stored, unplaced, unplacedTree, threadCount).take();
}

}  // namespace candela::scene

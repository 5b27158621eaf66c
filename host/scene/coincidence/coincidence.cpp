// Finds overlapping surfaces in one plane among those whose boxes overlap.
#include "host/scene/coincidence/coincidence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <span>

#include "host/base/run_on_threads.h"
#include "host/scene/coincidence/box_tree.h"
#include "host/scene/coincidence/flat_surfaces.h"
#include "host/scene/coincidence/instance_contacts.h"
#include "host/scene/shape.h"

namespace candela::scene {
namespace {

// A comparison of two boxes is a unit of work.
constexpr std::uint64_t kMaxWork = 1u << 29;
constexpr std::uint64_t kWorkOfTest = 16;     // of a call of overlapInPlane()
constexpr std::uint64_t kWorkOfOverlap = 32;  // of a pair that is stored

using Overlaps = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

// Compares surfaces on several threads, each of which has a list of its own.
class Comparison {
 public:
  Comparison(const FlatSurfaces& surfaces, const BoxTree& tree, std::uint32_t threadCount)
      : surfaces_(surfaces), tree_(tree), found_(threadCount) {}

  void compareFinite() {
    tree_.visitPairs(limit_, [&](std::uint32_t thread, std::span<const BoxTree::Pair> pairs) {
      for (const auto& [a, b] : pairs) compare(surfaces_[a], surfaces_[b], thread);
      limit_.add(kWorkOfTest * pairs.size());
    });
  }

  void compareInfinite() {
    const std::span<const FlatSurface> planes = surfaces_.infinite();
    forEachOnThreads(
        static_cast<std::uint32_t>(found_.size()), planes.size(), [&](std::uint32_t thread, std::size_t i) {
          if (limit_.isExceeded()) return;
          for (const FlatSurface& other : planes.first(i)) compare(planes[i], other, thread);
          limit_.add(kWorkOfTest * i);
          const auto passes = [&](const glm::vec3& low, const glm::vec3& high) {
            return mayLieIn(planes[i], low, high);
          };
          tree_.visitItems(limit_, passes, [&](std::uint32_t item) { compare(planes[i], surfaces_[item], thread); });
        });
  }

  bool isTruncated() const { return limit_.isExceeded(); }

  // Returns all pairs in their order, each once.
  Overlaps take() {
    Overlaps all;
    for (Overlaps& list : found_) {
      all.insert(all.end(), list.begin(), list.end());
      list = {};
    }
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

 private:
  void compare(const FlatSurface& a, const FlatSurface& b, std::uint32_t thread) {
    if (a.primitive == b.primitive || !overlapInPlane(a, b)) return;
    found_[thread].push_back(std::minmax(a.primitive, b.primitive));
    limit_.add(kWorkOfOverlap);
  }

  const FlatSurfaces& surfaces_;
  const BoxTree& tree_;
  WorkLimit limit_{kMaxWork};
  std::vector<Overlaps> found_;
};

struct LargestCoordinate {
  float operator()(const Sphere& s) const { return reachOf(std::array{s.centre}) + std::abs(s.radius); }
  float operator()(const Triangle& t) const { return reachOf(t.p); }
  float operator()(const Box& box) const { return reachOf(std::array{box.min, box.max}); }
  float operator()(const Cone& c) const {
    return reachOf(std::array{c.base, c.apex}) + std::max(c.baseRadius, c.apexRadius);
  }
  float operator()(const Plane& plane) const { return reachOf(std::array{plane.p[0]}); }
};

// Marks primitives, by what is known of pairs.
class Marking {
 public:
  // `firstCopy`: result of firstUnplacedCopies().
  Marking(const Scene& scene, const StoredPrimitives& stored, std::span<const std::uint32_t> firstCopy,
          const InstanceContacts& instances, Coincidences& result)
      : scene_(scene),
        runs_(scene.primitives.runs()),
        stored_(stored),
        firstCopy_(firstCopy),
        instances_(instances),
        result_(result) {}

  void markCoincident() {
    std::vector<bool>& marks = result_.coincident;
    marks.resize(stored_.count());
    forEachPair(
        [&](std::uint32_t a, std::uint32_t b) { marks[stored_.indexOf(a)] = marks[stored_.indexOf(b)] = true; });
    const auto mark = [&](std::uint32_t number) { marks[number] = true; };
    for (const auto& [a, b] : instances_.copiedRuns) forEachFlat(a, mark);
    for (const auto& [a, b] : instances_.unsearched) forEachFlat(a, mark), forEachFlat(b, mark);
    std::ranges::for_each(instances_.uncertain, mark);
    for (std::uint32_t run = 0; result_.truncated && run < runs_.size(); ++run) {
      if (stored_.isFirst(run)) forEachFlat(run, mark);
    }
  }

  // Copies share the marks that their first copy has.
  void markBehind() {
    result_.behind.resize(stored_.count());
    noteEmitters();
    if (std::ranges::count(emits_, true) == 0) return;
    std::vector<bool> holdsEmitter = emits_;
    forEachPair([&](std::uint32_t a, std::uint32_t b) {
      if (emits_[copyOf(a)]) holdsEmitter[copyOf(b)] = true;
      if (emits_[copyOf(b)]) holdsEmitter[copyOf(a)] = true;
    });
    const auto hold = [&](std::uint32_t number) { holdsEmitter[firstCopy_[number]] = true; };
    for (const auto& [a, b] : instances_.unsearched) {
      if (hasEmitter(a)) forEachFlat(b, hold);
      if (hasEmitter(b)) forEachFlat(a, hold);
    }
    for (std::uint32_t run = 0; run < runs_.size(); ++run) {
      if (!stored_.isFirst(run) || !isDark_[stored_.firstOf(run)]) continue;
      forEach(run, [&](std::uint32_t number) { result_.behind[number] = holdsEmitter[firstCopy_[number]]; });
    }
    noteReach();
  }

 private:
  bool isUnplaced(std::uint32_t run) const { return !runs_[run].start.isPlaced(); }

  // Returns the number of the first copy of a primitive.
  std::uint32_t copyOf(std::uint32_t primitive) const { return firstCopy_[stored_.indexOf(primitive)]; }

  void forEachPair(const std::function<void(std::uint32_t a, std::uint32_t b)>& visit) const {
    for (const auto& [a, b] : result_.overlaps) visit(a, b);
    for (const auto& [a, b] : result_.copies) visit(a, b);
  }

  // Visits the numbers of the primitives of a run, which may be kUnplacedRuns.
  template <class Visit>
  void forEach(std::uint32_t run, const Visit& visit) const {
    if (run == kUnplacedRuns) {
      for (std::uint32_t i = 0; i < runs_.size(); ++i) {
        if (isUnplaced(i)) forEach(i, visit);
      }
      return;
    }
    const std::uint32_t first = stored_.firstOf(run), count = scene_.primitives.countOf(runs_[run]);
    for (std::uint32_t number = first; number < first + count; ++number) visit(number);
  }

  template <class Visit>
  void forEachFlat(std::uint32_t run, const Visit& visit) const {
    forEach(run, [&](std::uint32_t number) {
      if (flatPartCount(scene_.primitives[stored_.primitiveOf(number)].kind) > 0) visit(number);
    });
  }

  bool hasEmitter(std::uint32_t run) const {
    bool has = false;
    forEach(run, [&](std::uint32_t number) { has = has || emits_[firstCopy_[number]]; });
    return has;
  }

  // Instances share what is known of their materials, too.
  void noteEmitters() {
    std::vector<bool> emits(stored_.count());
    isDark_.resize(stored_.count());
    for (std::uint32_t run = 0; run < runs_.size(); ++run) {
      (isEmissive(scene_.materials[runs_[run].start.material]) ? emits : isDark_)[stored_.firstOf(run)] = true;
    }
    emits_.resize(stored_.count());
    for (std::uint32_t run = 0; run < runs_.size(); ++run) {
      if (!stored_.isFirst(run) || !emits[stored_.firstOf(run)]) continue;
      forEach(run, [&](std::uint32_t number) { emits_[firstCopy_[number]] = true; });
    }
  }

  void noteReach() {
    std::vector<bool> isInvolved(stored_.count());
    for (std::uint32_t number = 0; number < stored_.count(); ++number) {
      if (result_.behind[number]) isInvolved[firstCopy_[number]] = true;
    }
    forEachPair([&](std::uint32_t a, std::uint32_t b) {
      if (isInvolved[copyOf(a)] && emits_[copyOf(b)]) isInvolved[copyOf(b)] = true;
      if (isInvolved[copyOf(b)] && emits_[copyOf(a)]) isInvolved[copyOf(a)] = true;
    });
    const auto involve = [&](std::uint32_t number) {
      if (emits_[number]) isInvolved[number] = true;
    };
    for (const auto& [a, b] : instances_.unsearched) forEach(a, involve), forEach(b, involve);
    std::vector<bool> hasInvolved(stored_.count());  // by the number of a run's first primitive
    for (std::uint32_t run = 0; run < runs_.size(); ++run) {
      if (!stored_.isFirst(run)) continue;
      forEach(run, [&](std::uint32_t number) {
        if (!isInvolved[number]) return;
        hasInvolved[stored_.firstOf(run)] = true;
        if (isUnplaced(run)) include(reachOf(stored_.primitiveOf(number)));
      });
    }
    for (std::uint32_t run = 0; run < runs_.size(); ++run) {
      if (!isUnplaced(run) && hasInvolved[stored_.firstOf(run)]) include(instances_.reaches[run]);
    }
  }

  float reachOf(std::uint32_t primitive) const {
    return std::visit(LargestCoordinate(), shapeOf(scene_, scene_.primitives[primitive]));
  }
  void include(float reach) { result_.behindReach = std::max(result_.behindReach, reach); }

  const Scene& scene_;
  std::span<const PrimitiveRun> runs_;
  const StoredPrimitives& stored_;
  std::span<const std::uint32_t> firstCopy_;
  const InstanceContacts& instances_;
  Coincidences& result_;
  std::vector<bool> emits_;   // by first copy: whether a copy emits in some instance
  std::vector<bool> isDark_;  // by the number of a run's first primitive: whether it does not emit in some instance
};

}  // namespace

Coincidences findCoincidences(const Scene& scene, std::uint32_t threads) {
  const std::uint32_t threadCount = threadCountFor(threads);
  const StoredPrimitives stored(scene.primitives);
  const std::vector<std::uint32_t> firstCopy = firstUnplacedCopies(scene, stored, threadCount);
  FlatSurfaces surfaces(scene, stored, firstCopy, threadCount);
  const BoxTree tree(surfaces.takeBoxes(), threadCount);
  Comparison comparison(surfaces, tree, threadCount);
  comparison.compareFinite();
  comparison.compareInfinite();
  const InstanceContacts instances = findInstanceContacts(scene, stored, surfaces, tree, threadCount);
  Coincidences result;
  for (std::uint32_t number = 0; number < firstCopy.size(); ++number) {
    if (firstCopy[number] == number) continue;
    result.copies.emplace_back(stored.primitiveOf(firstCopy[number]), stored.primitiveOf(number));
  }
  result.copies.insert(result.copies.end(), instances.copies.begin(), instances.copies.end());
  result.copiedRuns = instances.copiedRuns;
  result.truncated = comparison.isTruncated() || instances.truncated;
  if (!result.truncated) {
    result.overlaps = comparison.take();
    result.overlaps.insert(result.overlaps.end(), instances.overlaps.begin(), instances.overlaps.end());
  }
  Marking marking(scene, stored, firstCopy, instances, result);
  marking.markCoincident();
  marking.markBehind();
  return result;
}

}  // namespace candela::scene

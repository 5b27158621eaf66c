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

// Classes of materials that have places of their own in the order in a plane, as bits.
using Classes = std::uint8_t;
constexpr Classes kEmits = 1, kThinWalled = 2, kBody = 4, kOther = 8;

Classes classOf(const Scene& scene, std::uint32_t index) {
  const Material& material = scene.materials[index];
  if (isEmissive(material)) return kEmits;
  if (material.whitted && material.whitted->kind == WhittedKind::glass) return kBody;
  if (!anyMaterial(scene, index, transmits)) return kOther;
  return material.surface && !material.surface->hasVolume() ? kThinWalled : kBody;
}

// Returns whether a surface of one of the classes `own` may be ordered in relation to one of `others`.
bool mayDifferInPlace(Classes own, Classes others) {
  const Classes ordered = own & ~kEmits;
  if (ordered == 0) return false;
  const bool isOfOneClass = ordered == kThinWalled || ordered == kOther;  // bodies are entered or exited
  return (others & ~(isOfOneClass ? ordered : 0)) != 0;
}

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

  // Copies share what is known of their first copy.
  void markOrdered() {
    result_.ordered.resize(stored_.count());
    noteClasses();
    std::vector<Classes> others(stored_.count());  // classes of what coincides, by first copy
    forEachPair([&](std::uint32_t a, std::uint32_t b) {
      others[copyOf(a)] |= classes_[copyOf(b)];
      others[copyOf(b)] |= classes_[copyOf(a)];
    });
    forEachPairOfRuns([&](std::uint32_t a, std::uint32_t b) {
      const Classes ofB = classesIn(b);
      forEachFlat(a, [&](std::uint32_t number) { others[firstCopy_[number]] |= ofB; });
    });
    for (const std::uint32_t number : instances_.uncertain) others[firstCopy_[number]] |= classes_[firstCopy_[number]];
    for (std::uint32_t run = 0; run < runs_.size(); ++run) {
      if (!stored_.isFirst(run)) continue;
      const Classes own = classesOfRun_[stored_.firstOf(run)];
      forEach(run, [&](std::uint32_t number) {
        result_.ordered[number] = mayDifferInPlace(own, others[firstCopy_[number]]);
      });
    }
    if (std::ranges::count(result_.ordered, true) > 0) noteReach();
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

  // Visits pairs of runs in both orders that coincide everywhere, or of which nothing is known.
  void forEachPairOfRuns(const std::function<void(std::uint32_t a, std::uint32_t b)>& visit) const {
    for (const auto* pairs : {&instances_.unsearched, &instances_.copiedRuns}) {
      for (const auto& [a, b] : *pairs) visit(a, b), visit(b, a);
    }
  }

  Classes classesIn(std::uint32_t run) const {
    Classes classes = 0;
    forEach(run, [&](std::uint32_t number) { classes |= classes_[firstCopy_[number]]; });
    return classes;
  }

  // Instances share what is known of their materials, too.
  void noteClasses() {
    classesOfRun_.resize(stored_.count());
    for (std::uint32_t run = 0; run < runs_.size(); ++run) {
      classesOfRun_[stored_.firstOf(run)] |= classOf(scene_, runs_[run].start.material);
    }
    classes_.resize(stored_.count());
    for (std::uint32_t run = 0; run < runs_.size(); ++run) {
      if (!stored_.isFirst(run)) continue;
      forEach(run, [&](std::uint32_t number) { classes_[firstCopy_[number]] |= classesOfRun_[stored_.firstOf(run)]; });
    }
  }

  void noteReach() {
    std::vector<bool> isOrdered(stored_.count());  // by first copy, as the next one
    for (std::uint32_t number = 0; number < stored_.count(); ++number) {
      if (result_.ordered[number]) isOrdered[firstCopy_[number]] = true;
    }
    std::vector<bool> isInvolved = isOrdered;
    forEachPair([&](std::uint32_t a, std::uint32_t b) {
      if (isOrdered[copyOf(a)]) isInvolved[copyOf(b)] = true;
      if (isOrdered[copyOf(b)]) isInvolved[copyOf(a)] = true;
    });
    const auto hasOrdered = [&](std::uint32_t run) {
      bool has = false;
      forEach(run, [&](std::uint32_t number) { has = has || isOrdered[firstCopy_[number]]; });
      return has;
    };
    const auto involve = [&](std::uint32_t number) { isInvolved[firstCopy_[number]] = true; };
    for (const auto& [a, b] : instances_.unsearched) {
      if (hasOrdered(a) || hasOrdered(b)) forEachFlat(a, involve), forEachFlat(b, involve);
    }
    std::vector<bool> hasInvolved(stored_.count());  // by the number of a run's first primitive
    for (std::uint32_t run = 0; run < runs_.size(); ++run) {
      if (!stored_.isFirst(run)) continue;
      forEach(run, [&](std::uint32_t number) {
        if (!isInvolved[firstCopy_[number]]) return;
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
  void include(float reach) { result_.orderReach = std::max(result_.orderReach, reach); }

  const Scene& scene_;
  std::span<const PrimitiveRun> runs_;
  const StoredPrimitives& stored_;
  std::span<const std::uint32_t> firstCopy_;
  const InstanceContacts& instances_;
  Coincidences& result_;
  std::vector<Classes> classes_;       // of all copies in all instances, by first copy
  std::vector<Classes> classesOfRun_;  // in all instances, by the number of a run's first primitive
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
  marking.markOrdered();
  return result;
}

}  // namespace candela::scene

// Finds overlapping surfaces in one plane among those whose boxes overlap.
#include "host/scene/coincidence/coincidence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <span>
#include <utility>

#include "host/base/run_on_threads.h"
#include "host/scene/coincidence/box_tree.h"
#include "host/scene/coincidence/flat_surface.h"
#include "host/scene/shape.h"

namespace candela::scene {
namespace {

// A comparison of two boxes is a unit of work.
constexpr std::uint64_t kMaxWork = 1u << 29;
constexpr std::uint64_t kWorkOfTest = 16;     // of a call of overlapInPlane()
constexpr std::uint64_t kWorkOfOverlap = 32;  // of a pair that is stored

using Overlaps = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

// The flat surfaces of all primitives other than copies.
class FlatSurfaces {
 public:
  FlatSurfaces(const Scene& scene, std::span<const std::uint32_t> firstCopy, std::uint32_t threadCount) {
    std::vector<std::size_t> first(firstCopy.size());  // index of the first part of each primitive
    std::size_t count = 0;
    for (std::uint32_t i = 0; i < firstCopy.size(); ++i) {
      first[i] = count;
      if (firstCopy[i] == i) count += partCount(scene.primitives[i]);
    }
    surfaces_ = std::make_unique_for_overwrite<FlatSurface[]>(count);
    boxes_.resize(count, {{}, {}, kNone});
    forEachBlock(threadCount, firstCopy.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        if (firstCopy[i] == i) store(scene, static_cast<std::uint32_t>(i), first[i]);
      }
    });
    std::erase_if(boxes_, [](const ItemBox& box) { return box.item == kNone; });
    storePlanes(scene, firstCopy);
  }

  const FlatSurface& operator[](std::uint32_t index) const { return surfaces_[index]; }
  std::vector<ItemBox> takeBoxes() { return std::move(boxes_); }
  std::span<const FlatSurface> infinite() const { return infinite_; }

 private:
  static constexpr std::uint32_t kNone = ~0u;

  static std::size_t partCount(const Primitive& primitive) {
    return primitive.kind == PrimitiveKind::plane ? 0 : flatPartCount(primitive.kind);
  }

  void store(const Scene& scene, std::uint32_t primitive, std::size_t first) {
    const std::size_t count = partCount(scene.primitives[primitive]);
    if (count == 0) return;
    const std::span<FlatSurface> parts(&surfaces_[first], count);
    const std::size_t stored = storeFlatParts(shapeOf(scene, scene.primitives[primitive]), primitive, parts);
    for (std::size_t i = first; i < first + stored; ++i) {
      boxes_[i] = boxOf(surfaces_[i], static_cast<std::uint32_t>(i));
    }
  }

  void storePlanes(const Scene& scene, std::span<const std::uint32_t> firstCopy) {
    for (std::uint32_t i = 0; i < firstCopy.size(); ++i) {
      if (firstCopy[i] != i || scene.primitives[i].kind != PrimitiveKind::plane) continue;
      infinite_.emplace_back();
      storeFlatParts(shapeOf(scene, scene.primitives[i]), i, std::span(infinite_).last(1));
    }
  }

  std::unique_ptr<FlatSurface[]> surfaces_;
  std::vector<ItemBox> boxes_;
  std::vector<FlatSurface> infinite_;
};

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

void markCoincident(const Scene& scene, Coincidences& result) {
  const auto count = static_cast<std::uint32_t>(result.firstCopy.size());
  result.coincident.resize(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (result.firstCopy[i] != i) result.coincident[result.firstCopy[i]] = result.coincident[i] = true;
    if (result.truncated && flatPartCount(scene.primitives[i].kind) > 0) result.coincident[i] = true;
  }
  for (const auto& [a, b] : result.overlaps) result.coincident[a] = result.coincident[b] = true;
}

struct LargestCoordinate {
  float operator()(const Sphere& s) const { return reachOf(std::array{s.centre}) + std::abs(s.radius); }
  float operator()(const Triangle& t) const { return reachOf(t.p); }
  float operator()(const Box& box) const { return reachOf(std::array{box.min, box.max}); }
  float operator()(const Cone& c) const {
    return reachOf(std::array{c.base, c.apex}) + std::max(c.baseRadius, c.apexRadius);
  }
  float operator()(const Plane& plane) const { return reachOf(std::array{plane.p[0]}); }
};

// Marks surfaces that are behind emitters. Copies share the marks that their first copy has.
void markBehind(const Scene& scene, Coincidences& result) {
  const auto count = static_cast<std::uint32_t>(result.firstCopy.size());
  result.behind.resize(count);
  std::vector<bool> emits(count), isInvolved(count);  // by first copy
  const auto emitsItself = [&](std::uint32_t i) { return isEmissive(scene.materials[scene.primitives[i].material]); };
  for (std::uint32_t i = 0; i < count; ++i) {
    if (emitsItself(i)) emits[result.firstCopy[i]] = true;
  }
  if (std::ranges::count(emits, true) == 0) return;
  std::vector<bool> holdsEmitter = emits;
  for (const auto& [a, b] : result.overlaps) {
    if (emits[a]) holdsEmitter[b] = true;
    if (emits[b]) holdsEmitter[a] = true;
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    result.behind[i] = holdsEmitter[result.firstCopy[i]] && !emitsItself(i);
    if (result.behind[i]) isInvolved[result.firstCopy[i]] = true;
  }
  for (const auto& [a, b] : result.overlaps) {
    if (isInvolved[a] && emits[b]) isInvolved[b] = true;
    if (isInvolved[b] && emits[a]) isInvolved[a] = true;
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    if (!isInvolved[i]) continue;
    const float reach = std::visit(LargestCoordinate(), shapeOf(scene, scene.primitives[i]));
    result.behindReach = std::max(result.behindReach, reach);
  }
}

}  // namespace

Coincidences findCoincidences(const Scene& scene, std::uint32_t threads) {
  const std::uint32_t threadCount = threadCountFor(threads);
  Coincidences result;
  result.firstCopy = firstCopies(scene, threadCount);
  FlatSurfaces surfaces(scene, result.firstCopy, threadCount);
  const BoxTree tree(surfaces.takeBoxes(), threadCount);
  Comparison comparison(surfaces, tree, threadCount);
  comparison.compareFinite();
  comparison.compareInfinite();
  result.truncated = comparison.isTruncated();
  if (!result.truncated) result.overlaps = comparison.take();
  markCoincident(scene, result);
  markBehind(scene, result);
  return result;
}

}  // namespace candela::scene

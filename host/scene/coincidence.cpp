// Finds copies by a hash of their shape, and overlapping surfaces in one plane by a recursive partition of space.
#include "host/scene/coincidence.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>

#include "host/core/hash.h"
#include "host/scene/shape.h"

namespace candela::scene {
namespace {

using glm::dvec3;
using glm::vec3;

// The numbers that describe a shape; equal shapes have equal numbers.
using ShapeKey = std::array<float, 10>;

bool isLess(const vec3& a, const vec3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); }

// Numbers of a key. Adding 0 turns -0 into 0.
template <class... Values>
ShapeKey keyOf(PrimitiveKind kind, const Values&... values) {
  ShapeKey key{static_cast<float>(kind)};
  std::size_t next = 1;
  const auto append = [&](const vec3& v) {
    for (int axis = 0; axis < 3; ++axis) key[next++] = v[axis] + 0.0f;
  };
  (append(values), ...);
  return key;
}

struct KeyOfShape {
  ShapeKey operator()(const Sphere& s) const {
    return keyOf(PrimitiveKind::sphere, s.centre, vec3(std::abs(s.radius), 0, 0));
  }
  ShapeKey operator()(const Triangle& triangle) const {
    std::array<vec3, 3> p{triangle.p[0], triangle.p[1], triangle.p[2]};
    std::ranges::sort(p, isLess);
    return keyOf(PrimitiveKind::triangle, p[0], p[1], p[2]);
  }
  ShapeKey operator()(const Box& box) const { return keyOf(PrimitiveKind::box, box.min, box.max); }
  ShapeKey operator()(const Cone& cone) const {
    const Cone sorted = withSortedEnds(cone);
    return keyOf(PrimitiveKind::cone, sorted.base, sorted.apex, vec3(sorted.baseRadius, sorted.apexRadius, 0));
  }
  ShapeKey operator()(const Plane& plane) const {
    return keyOf(PrimitiveKind::plane, plane.p[0], plane.p[1], plane.p[2]);
  }
};

ShapeKey keyOf(const Scene& scene, std::uint32_t primitive) {
  return std::visit(KeyOfShape(), shapeOf(scene, scene.primitives[primitive]));
}

std::uint64_t hashOf(const ShapeKey& key) {
  std::uint64_t hash = 0;
  for (const float value : key) hash = splitMix(hash ^ std::bit_cast<std::uint32_t>(value));
  return hash;
}

// ---------------------------------------------------------------------------------------------------------------------

// A flat surface with its bounds, which are padded by the tolerance.
struct Flat {
  std::array<vec3, 4> corners;
  std::uint32_t cornerCount;  // 0: infinite, and the first corner is a point of the plane
  std::uint32_t primitive;
  vec3 low, high;
  float reach;   // largest coordinate
  dvec3 normal;  // unit

  std::span<const vec3> polygon() const { return std::span(corners).first(cornerCount); }
};

float largest(const vec3& v) { return std::max({v.x, v.y, v.z}); }

float reachOf(std::span<const vec3> points) {
  float reach = 0;
  for (const vec3& point : points) reach = std::max(reach, largest(glm::abs(point)));
  return reach;
}

// Appends a polygon; nothing if it has no area.
void appendPolygon(std::span<const vec3> corners, const dvec3& areaNormal, std::uint32_t primitive,
                   std::vector<Flat>& flats) {
  if (!(length(areaNormal) > 0)) return;
  Flat flat{{},
            static_cast<std::uint32_t>(corners.size()),
            primitive,
            corners[0],
            corners[0],
            reachOf(corners),
            normalize(areaNormal)};
  std::ranges::copy(corners, flat.corners.begin());
  for (const vec3& corner : corners) flat.low = glm::min(flat.low, corner), flat.high = glm::max(flat.high, corner);
  const float pad = static_cast<float>(kCoplanarTolerance) * flat.reach;
  flat.low -= pad;
  flat.high += pad;
  flats.push_back(flat);
}

// Appends the flat parts of a shape.
struct AppendFlats {
  std::uint32_t primitive;
  std::vector<Flat>& finite;
  std::vector<Flat>& infinite;

  void operator()(const Triangle& t) const {
    const dvec3 normal = cross(dvec3(t.p[1]) - dvec3(t.p[0]), dvec3(t.p[2]) - dvec3(t.p[0]));
    appendPolygon(std::array<vec3, 3>{t.p[0], t.p[1], t.p[2]}, normal, primitive, finite);
  }
  void operator()(const Box& box) const {
    for (int axis = 0; axis < 3; ++axis) {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      for (const float at : {box.min[axis], box.max[axis]}) {
        std::array<vec3, 4> corners;
        for (std::size_t i = 0; i < 4; ++i) {
          corners[i][axis] = at;
          corners[i][u] = (i == 1 || i == 2 ? box.max : box.min)[u];
          corners[i][v] = (i >= 2 ? box.max : box.min)[v];
        }
        appendPolygon(corners, cross(dvec3(corners[1] - corners[0]), dvec3(corners[3] - corners[0])), primitive,
                      finite);
      }
    }
  }
  void operator()(const Plane& plane) const {
    const dvec3 p(plane.p[0]);
    const dvec3 normal = normalize(cross(dvec3(plane.p[1]) - p, dvec3(plane.p[2]) - p));
    infinite.push_back({{plane.p[0]}, 0, primitive, {}, {}, largest(glm::abs(plane.p[0])), normal});
  }
  void operator()(const Sphere&) const {}
  void operator()(const Cone&) const {}
};

bool isWithin(const Flat& flat, const Flat& plane, double tolerance) {
  return std::ranges::all_of(flat.polygon(), [&](const vec3& corner) {
    return std::abs(dot(dvec3(corner) - dvec3(plane.corners[0]), plane.normal)) <= tolerance;
  });
}

// Returns whether a line along an edge of `a` separates two polygons, up to an overlap of this depth.
bool separates(const Flat& a, const Flat& b, int u, int v, double depth) {
  for (std::uint32_t i = 0; i < a.cornerCount; ++i) {
    const vec3& from = a.corners[i];
    const vec3& to = a.corners[(i + 1) % a.cornerCount];
    const glm::dvec2 across(double{from[v]} - to[v], double{to[u]} - from[u]);
    const auto height = [&](const vec3& p) {
      return across.x * (double{p[u]} - from[u]) + across.y * (double{p[v]} - from[v]);
    };
    double side = 0;  // of the third corner of `a`, all of which is on the same side
    for (const vec3& corner : a.polygon()) side = std::abs(height(corner)) > std::abs(side) ? height(corner) : side;
    double deepest = -std::numeric_limits<double>::infinity();
    for (const vec3& corner : b.polygon()) deepest = std::max(deepest, side > 0 ? height(corner) : -height(corner));
    if (deepest <= depth * length(across)) return true;
  }
  return false;
}

// Returns whether two flat surfaces lie in one plane and, if both are finite, overlap by more than the tolerance.
bool overlapInPlane(const Flat& a, const Flat& b) {
  constexpr double kParallel = 0.9;  // rounding turns the normals of small triangles far from the origin
  if (std::abs(dot(a.normal, b.normal)) < kParallel) return false;
  const double tolerance = kCoplanarTolerance * double{std::max(a.reach, b.reach)};
  const bool aIsFinite = a.cornerCount > 0, bIsFinite = b.cornerCount > 0;
  if (!aIsFinite && !bIsFinite) {
    const bool isParallel = length(cross(a.normal, b.normal)) <= kCoplanarTolerance;
    return isParallel && std::abs(dot(dvec3(a.corners[0]) - dvec3(b.corners[0]), b.normal)) <= tolerance;
  }
  const auto isCoplanar = [&] {
    return (aIsFinite && isWithin(a, b, tolerance)) || (bIsFinite && isWithin(b, a, tolerance));
  };
  if (!aIsFinite || !bIsFinite) return isCoplanar();
  const dvec3 size = glm::abs(a.normal);
  const int dropped = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const int u = (dropped + 1) % 3, v = (dropped + 2) % 3;
  return !separates(a, b, u, v, tolerance) && !separates(b, a, u, v, tolerance) && isCoplanar();
}

bool boundsOverlap(const Flat& a, const Flat& b) {
  return glm::all(glm::lessThanEqual(a.low, b.high)) && glm::all(glm::lessThanEqual(b.low, a.high));
}

// Compares flat surfaces whose bounds overlap. Space is halved until few surfaces are left in each part.
class Partition {
 public:
  Partition(const std::vector<Flat>& flats, Coincidences& result) : flats_(flats), result_(result) {}

  void search(std::vector<std::uint32_t> items, int depth = 0) {
    if (result_.truncated) return;
    vec3 low(INFINITY), high(-INFINITY);
    for (const std::uint32_t item : items) {
      const vec3 centre = 0.5f * (flats_[item].low + flats_[item].high);
      low = glm::min(low, centre), high = glm::max(high, centre);
    }
    if (items.size() <= kLeafSize || depth == kMaxDepth || !split(items, low, high, depth)) compareAll(items);
  }

 private:
  static constexpr std::size_t kLeafSize = 12;
  static constexpr int kMaxDepth = 48;
  static constexpr std::uint64_t kMaxComparisons = 1u << 28;

  // Searches both halves along the axis that separates best; returns false if none does. Clears `items` to save memory.
  bool split(std::vector<std::uint32_t>& items, const vec3& low, const vec3& high, int depth) {
    const vec3 extent = high - low;
    std::array<int, 3> axes{0, 1, 2};
    std::ranges::sort(axes, [&](int a, int b) { return extent[a] > extent[b]; });
    for (const int axis : axes) {
      const float middle = 0.5f * (low[axis] + high[axis]);
      std::vector<std::uint32_t> lower, upper;
      for (const std::uint32_t item : items) {
        if (flats_[item].low[axis] <= middle) lower.push_back(item);
        if (flats_[item].high[axis] >= middle) upper.push_back(item);
      }
      if (4 * std::max(lower.size(), upper.size()) > 3 * items.size() + 4) continue;
      items = {};
      search(std::move(lower), depth + 1);
      search(std::move(upper), depth + 1);
      return true;
    }
    return false;
  }

  void compareAll(const std::vector<std::uint32_t>& items) {
    for (std::size_t i = 0; i < items.size(); ++i) {
      const Flat& a = flats_[items[i]];
      for (std::size_t j = 0; j < i; ++j) {
        const Flat& b = flats_[items[j]];
        if (a.primitive != b.primitive && boundsOverlap(a, b) && overlapInPlane(a, b))
          result_.overlaps.push_back(std::minmax(a.primitive, b.primitive));
      }
      comparisons_ += i;
      if (comparisons_ > kMaxComparisons || result_.overlaps.size() > kMaxComparisons / 16) {
        result_.truncated = true;
        return;
      }
    }
  }

  const std::vector<Flat>& flats_;
  Coincidences& result_;
  std::uint64_t comparisons_ = 0;
};

void compareWithPlanes(const std::vector<Flat>& planes, const std::vector<Flat>& finite, Coincidences& result) {
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const auto compare = [&](const Flat& other) {
      if (overlapInPlane(planes[i], other))
        result.overlaps.push_back(std::minmax(planes[i].primitive, other.primitive));
    };
    std::for_each(planes.begin(), planes.begin() + static_cast<std::ptrdiff_t>(i), compare);
    std::ranges::for_each(finite, compare);
  }
}

void markCoincident(const std::vector<Flat>& finite, Coincidences& result) {
  const auto count = static_cast<std::uint32_t>(result.firstCopy.size());
  result.coincident.resize(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (result.firstCopy[i] != i) result.coincident[result.firstCopy[i]] = result.coincident[i] = true;
  }
  for (const auto& [a, b] : result.overlaps) result.coincident[a] = result.coincident[b] = true;
  if (result.truncated) {
    for (const Flat& flat : finite) result.coincident[flat.primitive] = true;
  }
}

struct LargestCoordinate {
  float operator()(const Sphere& s) const { return largest(glm::abs(s.centre)) + std::abs(s.radius); }
  float operator()(const Triangle& t) const { return reachOf(t.p); }
  float operator()(const Box& box) const { return reachOf(std::array<vec3, 2>{box.min, box.max}); }
  float operator()(const Cone& c) const {
    return reachOf(std::array<vec3, 2>{c.base, c.apex}) + std::max(c.baseRadius, c.apexRadius);
  }
  float operator()(const Plane& plane) const { return largest(glm::abs(plane.p[0])); }
};

// Marks surfaces that are behind emitters. Copies share the marks that their first copy has.
void markBehind(const Scene& scene, Coincidences& result) {
  const auto count = static_cast<std::uint32_t>(result.firstCopy.size());
  std::vector<bool> emits(count), holdsEmitter(count), isInvolved(count);  // by first copy
  const auto emitsItself = [&](std::uint32_t i) { return isEmissive(scene.materials[scene.primitives[i].material]); };
  for (std::uint32_t i = 0; i < count; ++i) {
    if (emitsItself(i)) emits[result.firstCopy[i]] = true;
  }
  for (std::uint32_t i = 0; i < count; ++i) holdsEmitter[i] = emits[i];
  for (const auto& [a, b] : result.overlaps) {
    if (emits[a]) holdsEmitter[b] = true;
    if (emits[b]) holdsEmitter[a] = true;
  }
  result.behind.resize(count);
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

Cone withSortedEnds(Cone cone) {
  if (isLess(cone.apex, cone.base)) {
    std::swap(cone.base, cone.apex);
    std::swap(cone.baseRadius, cone.apexRadius);
  }
  return cone;
}

std::vector<std::uint32_t> firstCopies(const Scene& scene) {
  std::vector<std::uint32_t> first(scene.primitives.size());
  std::iota(first.begin(), first.end(), 0u);
  std::vector<std::pair<std::uint64_t, std::uint32_t>> hashes;
  hashes.reserve(first.size());
  for (const std::uint32_t i : first) hashes.emplace_back(hashOf(keyOf(scene, i)), i);
  std::ranges::sort(hashes);
  for (std::size_t i = 1; i < hashes.size(); ++i) {
    const auto& [hash, primitive] = hashes[i - 1];
    const auto& [nextHash, next] = hashes[i];
    if (hash == nextHash && keyOf(scene, primitive) == keyOf(scene, next)) first[next] = first[primitive];
  }
  return first;
}

bool Coincidences::any() const { return std::ranges::find(coincident, true) != coincident.end(); }

Coincidences findCoincidences(const Scene& scene) {
  Coincidences result;
  result.firstCopy = firstCopies(scene);
  std::vector<Flat> finite, infinite;
  for (std::uint32_t i = 0; i < result.firstCopy.size(); ++i) {
    if (result.firstCopy[i] == i) std::visit(AppendFlats{i, finite, infinite}, shapeOf(scene, scene.primitives[i]));
  }
  std::vector<std::uint32_t> items(finite.size());
  std::iota(items.begin(), items.end(), 0u);
  Partition(finite, result).search(std::move(items));
  compareWithPlanes(infinite, finite, result);
  std::ranges::sort(result.overlaps);
  const auto repeated = std::ranges::unique(result.overlaps);
  result.overlaps.erase(repeated.begin(), repeated.end());
  markCoincident(finite, result);
  markBehind(scene, result);
  return result;
}

}  // namespace candela::scene

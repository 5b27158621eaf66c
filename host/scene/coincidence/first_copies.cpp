// Finds copies by a hash table of their shapes.
#include <algorithm>
#include <array>
#include <bit>
#include <tuple>
#include <utility>

#include "host/base/hash.h"
#include "host/base/run_on_threads.h"
#include "host/scene/coincidence/coincidence.h"
#include "host/scene/shape.h"

namespace candela::scene {
namespace {

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

// Returns a key that no shape and no other number has.
ShapeKey keyOfItself(std::uint32_t number) {
  return {-1, static_cast<float>(number >> 16), static_cast<float>(number & 0xffffu)};
}

std::uint32_t hashOf(const ShapeKey& key) {
  std::uint64_t hash = 0;
  for (std::size_t i = 0; i < key.size(); i += 2) {
    const auto word = [&](std::size_t k) { return std::uint64_t{std::bit_cast<std::uint32_t>(key[k])}; };
    hash = splitMix(hash ^ (word(i) | word(i + 1) << 32));
  }
  return static_cast<std::uint32_t>(hash);
}

// Returns for each index below `count` the lowest one with an equal key.
template <class KeyAt>
std::vector<std::uint32_t> firstEqual(std::size_t count, std::uint32_t threads, const KeyAt& keyAt) {
  constexpr std::uint32_t kFree = ~0u;
  std::vector<std::uint32_t> hashes(count), first(count);
  forEachBlock(threadCountFor(threads), count, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) hashes[i] = hashOf(keyAt(static_cast<std::uint32_t>(i)));
  });
  std::vector<std::uint32_t> table(std::bit_ceil(2 * count + 1), kFree);
  const std::size_t mask = table.size() - 1;
  for (std::uint32_t i = 0; i < count; ++i) {
    std::size_t slot = hashes[i] & mask;
    const auto isOther = [&](std::uint32_t known) { return hashes[known] != hashes[i] || keyAt(known) != keyAt(i); };
    while (table[slot] != kFree && isOther(table[slot])) slot = (slot + 1) & mask;
    if (table[slot] == kFree) table[slot] = i;
    first[i] = table[slot];
  }
  return first;
}

}  // namespace

Cone withSortedEnds(Cone cone) {
  if (isLess(cone.apex, cone.base)) {
    std::swap(cone.base, cone.apex);
    std::swap(cone.baseRadius, cone.apexRadius);
  }
  return cone;
}

bool areCopies(const Shape& a, const Shape& b) {
  if (a.index() != b.index()) return false;
  // Most triangles share no vertex, so that this is much faster than comparing keys.
  const Triangle* const triangle = std::get_if<Triangle>(&a);
  if (triangle) return std::ranges::is_permutation(triangle->p, std::get<Triangle>(b).p);
  return std::visit(KeyOfShape(), a) == std::visit(KeyOfShape(), b);
}

std::uint32_t hashOf(const Shape& shape) { return hashOf(std::visit(KeyOfShape(), shape)); }

std::vector<std::uint32_t> firstUnplacedCopies(const Scene& scene, const StoredPrimitives& stored,
                                               std::uint32_t threads) {
  return firstEqual(stored.count(), threads, [&](std::uint32_t number) {
    const Primitive primitive = scene.primitives[stored.primitiveOf(number)];
    return primitive.isPlaced() ? keyOfItself(number) : std::visit(KeyOfShape(), shapeOf(scene, primitive));
  });
}

}  // namespace candela::scene

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

ShapeKey keyOf(const Scene& scene, std::uint32_t primitive) {
  return std::visit(KeyOfShape(), shapeOf(scene, scene.primitives[primitive]));
}

std::uint32_t hashOf(const ShapeKey& key) {
  std::uint64_t hash = 0;
  for (std::size_t i = 0; i < key.size(); i += 2) {
    const auto word = [&](std::size_t k) { return std::uint64_t{std::bit_cast<std::uint32_t>(key[k])}; };
    hash = splitMix(hash ^ (word(i) | word(i + 1) << 32));
  }
  return static_cast<std::uint32_t>(hash);
}

std::vector<std::uint32_t> hashesOf(const Scene& scene, std::uint32_t threadCount) {
  std::vector<std::uint32_t> hashes(scene.primitives.size());
  forEachBlock(threadCount, hashes.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) hashes[i] = hashOf(keyOf(scene, static_cast<std::uint32_t>(i)));
  });
  return hashes;
}

}  // namespace

Cone withSortedEnds(Cone cone) {
  if (isLess(cone.apex, cone.base)) {
    std::swap(cone.base, cone.apex);
    std::swap(cone.baseRadius, cone.apexRadius);
  }
  return cone;
}

std::vector<std::uint32_t> firstCopies(const Scene& scene, std::uint32_t threads) {
  constexpr std::uint32_t kFree = ~0u;
  const std::vector<std::uint32_t> hashes = hashesOf(scene, threadCountFor(threads));
  std::vector<std::uint32_t> first(hashes.size());
  std::vector<std::uint32_t> table(std::bit_ceil(2 * hashes.size() + 1), kFree);
  const std::size_t mask = table.size() - 1;
  for (std::uint32_t i = 0; i < first.size(); ++i) {
    std::size_t slot = hashes[i] & mask;
    const auto isOther = [&](std::uint32_t known) {
      return hashes[known] != hashes[i] || keyOf(scene, known) != keyOf(scene, i);
    };
    while (table[slot] != kFree && isOther(table[slot])) slot = (slot + 1) & mask;
    if (table[slot] == kFree) table[slot] = i;
    first[i] = table[slot];
  }
  return first;
}

}  // namespace candela::scene

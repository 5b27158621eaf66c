// The closest hit by brute force, through a BVH, and through a grid, in single or double precision: the searches of
// the device, on the host. The traversal of the grid is that of host/trace/accel/grid.h.
#pragma once
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

#include "host/trace/accel/bvh.h"
#include "host/trace/accel/grid.h"
#include "tests/trace/accel/ray_tests.h"
#include "tests/trace/accel/wide_ray.h"

namespace candela::test {

using namespace accel;

template <class T>
struct Hit {
  T t = std::numeric_limits<T>::infinity();
  std::uint32_t primitive = ~0u;
  bool operator==(const Hit&) const = default;

  // At equal distances the lower primitive index wins.
  void offer(T otherT, std::uint32_t other) {
    if (otherT < t || (otherT == t && other < primitive)) *this = {otherT, other};
  }
};

/// A scene's finite primitives. `steps` counts nodes or cells, and primitives tested.
template <class T>
class Searcher {
 public:
  explicit Searcher(const scene::Scene& scene) : scene_(scene), bounds_(boundPrimitives(scene)) {}

  const std::vector<accel::Aabb>& boxes() const { return bounds_.bounds; }

  Hit<T> bruteForce(const Ray<T>& ray) {
    Hit<T> best;
    for (std::uint32_t i = 0; i < bounds_.finite.size(); ++i) test(ray, i, best);
    return best;
  }

  Hit<T> throughTree(const Ray<T>& ray, const Bvh& bvh) {
    const SlabRay<T> slabs(ray);
    Hit<T> best;
    std::vector<std::uint32_t> stack;
    if (!bvh.nodes.empty()) stack.push_back(0);
    while (!stack.empty()) {
      const BvhNode& node = bvh.nodes[stack.back()];
      stack.pop_back();
      ++steps;
      if (!slabs.enter(node.bounds, best.t)) continue;
      for (std::uint32_t i = 0; i < node.count; ++i) test(ray, bvh.primitiveIndices[node.first + i], best);
      if (node.isLeaf()) continue;
      stack.push_back(node.first);
      stack.push_back(node.first + 1);
    }
    return best;
  }

  Hit<T> throughWideTree(const Ray<T>& ray, const WideBvh& wide) {
    const WideRay<T> slabs(ray);
    Hit<T> best;
    std::vector<std::uint32_t> stack;
    if (!wide.nodes.empty()) stack.push_back(0);
    while (!stack.empty()) {
      const WideNode& node = wide.nodes[stack.back()];
      stack.pop_back();
      ++steps;
      std::uint32_t next = node.firstPrimitive;
      for (std::uint32_t child = 0; child < accel::kWideChildren; ++child) {
        const std::uint32_t leaf = node.leafMask >> (3 * child) & 7, first = next;
        next += static_cast<std::uint32_t>(std::popcount(leaf));
        if (!slabs.meets(node.boxes, child, best.t)) continue;
        if (node.innerMask >> child & 1) stack.push_back(node.block + child);
        for (std::uint32_t i = first; i < next; ++i) test(ray, wide.primitiveIndices[i], best);
      }
    }
    return best;
  }

  Hit<T> throughGrid(const Ray<T>& ray, const Grid& grid) {
    Hit<T> best;
    if (!grid.starts.empty()) walk(ray, grid, best);
    return best;
  }

  /// Returns whether a primitive of a higher index is hit at the same distance.
  bool isTie(const Ray<T>& ray, const Hit<T>& hit) const {
    for (std::uint32_t i = hit.primitive + 1; i < scene_.primitives.size(); ++i) {
      if (intersect(ray, scene_, scene_.primitives[i]) == hit.t) return true;
    }
    return false;
  }

  std::uint64_t steps = 0;

 private:
  void test(const Ray<T>& ray, std::uint32_t item, Hit<T>& best) {
    const std::uint32_t primitive = bounds_.finite[item];
    ++steps;
    if (const auto t = intersect(ray, scene_, scene_.primitives[primitive])) best.offer(*t, primitive);
  }

  void walk(const Ray<T>& ray, const Grid& grid, Hit<T>& best) {
    const GridShape& shape = grid.shape;
    const T pad = T{accel::kBoundsPad} * (largest(glm::abs(ray.origin)) + T{gridReach(shape)});
    const Vec<T> inverse = SlabRay<T>(ray).inverse;
    const Vec<T> t0 = (Vec<T>(shape.bounds.min) - (ray.origin + pad)) * inverse;
    const Vec<T> t1 = (Vec<T>(shape.bounds.max) - (ray.origin - pad)) * inverse;
    const Vec<T> near = glm::min(t0, t1), far = glm::max(t0, t1);
    const T start = std::max(largest(near), T{0}), exit = -largest(-far);
    if (start > exit) return;

    const Vec<T> crossed = glm::abs(ray.direction) * Vec<T>(shape.scale);
    const int driving = crossed.x >= crossed.y && crossed.x >= crossed.z ? 0 : crossed.y >= crossed.z ? 1 : 2;
    const T low = shape.bounds.min[driving], o = ray.origin[driving], d = ray.direction[driving];
    const auto width = static_cast<float>(shape.bounds.extent()[driving] / shape.sides[driving]);
    const bool backward = inverse[driving] < 0;
    const T signedPad = backward ? -pad : pad;
    const int step = backward ? -1 : 1, sides = static_cast<int>(shape.sides[driving]);
    for (int slice = cellAt(shape, driving, o - signedPad + start * d); slice >= 0 && slice < sides; slice += step) {
      const T planes[2] = {low + static_cast<T>(slice) * T{width}, low + static_cast<T>(slice + 1) * T{width}};
      const T enter = (planes[backward] - (o + signedPad)) * inverse[driving];
      const T leave = (planes[!backward] - (o - signedPad)) * inverse[driving];
      const T end = std::min(exit, best.t);
      if (std::max(enter, start) > end) return;
      const T from = std::max(std::min(enter, end), start), to = std::max(std::min(leave, end), start);
      visitSlice(ray, grid, driving, slice, {ray.origin + from * ray.direction, ray.origin + to * ray.direction}, pad,
                 best);
    }
  }

  void visitSlice(const Ray<T>& ray, const Grid& grid, int driving, int slice, const std::array<Vec<T>, 2>& ends, T pad,
                  Hit<T>& best) {
    const glm::uvec3& strides = grid.shape.strides;
    const int line = (driving + 1) % 3, column = (driving + 2) % 3;
    std::array<int, 3> first, last;
    for (const int axis : {line, column}) {
      const auto [least, greatest] = std::minmax(ends[0][axis], ends[1][axis]);
      first[static_cast<std::size_t>(axis)] = cellAt(grid.shape, axis, least - pad);
      last[static_cast<std::size_t>(axis)] = cellAt(grid.shape, axis, greatest + pad);
    }
    const auto at = [](const std::array<int, 3>& numbers, int axis) { return numbers[static_cast<std::size_t>(axis)]; };
    for (int b = at(first, column); b <= at(last, column); ++b) {
      for (int a = at(first, line); a <= at(last, line); ++a) {
        const std::uint32_t cell = static_cast<std::uint32_t>(slice) * strides[driving] +
                                   static_cast<std::uint32_t>(a) * strides[line] +
                                   static_cast<std::uint32_t>(b) * strides[column];
        ++steps;
        for (std::uint32_t i = grid.starts[cell]; i < grid.starts[cell + 1]; ++i) test(ray, grid.items[i], best);
      }
    }
  }

  // In the traversal's own precision: in double this is not quite the builder's arithmetic, which the argument allows
  // for.
  static int cellAt(const GridShape& shape, int axis, T x) {
    const T place = (x - T{shape.bounds.min[axis]}) * T{shape.scale[axis]};
    return static_cast<int>(std::clamp(place, T{0}, static_cast<T>(shape.sides[axis] - 1)));
  }
  static T largest(const Vec<T>& v) { return std::max({v.x, v.y, v.z}); }

  const scene::Scene& scene_;
  SceneBounds bounds_;
};

}  // namespace candela::test

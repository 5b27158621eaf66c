// Surfaces that exist twice, or that lie in one plane and overlap: docs/light-transport.md section 4.
#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include "host/scene/scene.h"
#include "host/scene/shape.h"
#include "host/scene/stored_primitives.h"

namespace candela::scene {

/// The tolerance within which the vertices of a flat surface lie in the plane of another one, as a fraction of the
/// largest coordinate of both.
inline constexpr double kCoplanarTolerance = 0x1p-21;

/// Returns the cone with its ends in lexicographical order, so that no order of them rounds a distance differently.
Cone withSortedEnds(Cone cone);

/// Returns whether two shapes are the same: triangles with the same vertices in any order, equal boxes and planes,
/// spheres with the same centre and the same radius apart from its sign, and cones with the same ends in either order.
bool areCopies(const Shape& a, const Shape& b);

/// Returns a hash that copies share.
std::uint32_t hashOf(const Shape& shape);

/// Returns for each number in StoredPrimitives the lowest number of a copy among the primitives that belong to no
/// instance, which is its own if there is no lower one. A triangle of an instance has its own number.
/// With 0 threads, there is one per core.
std::vector<std::uint32_t> firstUnplacedCopies(const Scene& scene, const StoredPrimitives& stored,
                                               std::uint32_t threads = 0);

/// Surfaces that coincide. Instances count as their triangles in the space of the scene. Marks are by number in
/// StoredPrimitives: a mark of an instance's triangle holds if it holds in any instance.
struct Coincidences {
  using Pair = std::pair<std::uint32_t, std::uint32_t>;

  /// Primitives (a, b), a < b, with the same shape. Of primitives that belong to no instance, a is the first copy of b.
  std::vector<Pair> copies;
  /// Pairs (a, b), a < b, of flat primitives other than copies that lie in one plane and overlap in more than an edge:
  /// triangles, faces of boxes, and planes. Copies of a and b are not listed again, and triangles of one mesh are
  /// listed for one instance.
  std::vector<Pair> overlaps;
  /// Runs (a, b) of Scene::primitives, a < b, that are copies: instances with equal triangles and placements. Their
  /// primitives are not among `copies`.
  std::vector<Pair> copiedRuns;
  /// Whether another primitive is a copy of it or overlaps it in one plane. It holds also where it would take too many
  /// comparisons to decide.
  std::vector<bool> coincident;
  /// Whether the search ended before all pairs were compared. `overlaps` is then empty, and `coincident` is true for
  /// every flat primitive. It depends on the scene alone.
  bool truncated = false;
  /// Whether it is ordered: it does not emit, and a surface that may have another place in the order in a plane is a
  /// copy of it or overlaps it in one plane. A triangle has the mark if it holds in any instance.
  std::vector<bool> ordered;
  /// The largest coordinate of all surfaces that are ordered and of those that coincide with them; 0 if there are none.
  /// An instance with such a triangle counts with the box around it.
  float orderReach = 0;
};

/// Searches in O(n log n), where n is what the scene stores, for meshes in which few boxes of triangles overlap, and
/// instances of which few are in contact; the work is limited. With 0 threads, there is one per core. The result does
/// not depend on their number.
Coincidences findCoincidences(const Scene& scene, std::uint32_t threads = 0);

}  // namespace candela::scene

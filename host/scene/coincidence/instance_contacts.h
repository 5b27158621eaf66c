// Coincident surfaces of instances, in time that depends on what the scene stores and on the contacts.
#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include "host/scene/coincidence/flat_surfaces.h"

namespace candela::scene {

/// A run of a scene's primitives, or all primitives that belong to no instance.
inline constexpr std::uint32_t kUnplacedRuns = ~0u;

/// Triangles of instances that coincide with other surfaces. Triangles without area, which are never hit, are left out.
struct InstanceContacts {
  using Pair = std::pair<std::uint32_t, std::uint32_t>;

  std::vector<Pair> copies;      ///< primitives (a, b), a < b, with the same vertices
  std::vector<Pair> overlaps;    ///< other primitives (a, b), a < b, that lie in one plane and overlap
  std::vector<Pair> copiedRuns;  ///< runs (a, b), a < b, with equal triangles and placements. a is the first such run;
                                 ///< the lists above have no primitives of b
  std::vector<Pair> unsearched;  ///< pairs of runs, or of kUnplacedRuns and a run, with too many comparisons
  /// Numbers in StoredPrimitives of triangles that may coincide with others of their mesh, in some instance.
  std::vector<std::uint32_t> uncertain;
  std::vector<float> reaches;  ///< for each run a bound of its largest coordinate; 0 if it is no instance
  bool truncated = false;      ///< too many comparisons: all lists but copiedRuns are empty
};

/// Compares instances with each other, with themselves, and with the surfaces that belong to no instance, whose finite
/// ones are in the tree. The result does not depend on the number of threads.
InstanceContacts findInstanceContacts(const Scene& scene, const StoredPrimitives& stored, const FlatSurfaces& unplaced,
                                      const BoxTree& unplacedTree, std::uint32_t threadCount);

}  // namespace candela::scene

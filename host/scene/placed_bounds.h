// The boxes around instances, computed without placing all of their vertices.
#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <tuple>

#include "host/scene/bounds.h"
#include "host/scene/coincidence/box_tree.h"

namespace candela::scene {

/// Stores a tree of the triangles of each mesh that it was asked for.
class PlacedBounds {
 public:
  /// The scene must outlive the object.
  explicit PlacedBounds(const Scene& scene) : scene_(scene) {}

  /// Returns the box around the vertices of the triangles of a run with a placement.
  Bounds of(const PrimitiveRun& run);

 private:
  const BoxTree& treeOf(const PrimitiveRun& run);

  const Scene& scene_;
  /// By mesh, first triangle and number of triangles. Items are indices of triangles in the mesh.
  std::map<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>, std::unique_ptr<BoxTree>> trees_;
};

}  // namespace candela::scene

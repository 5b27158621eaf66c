// The tree by which --lights tree chooses lights: docs/light-transport.md section 6.1.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "host/scene/scene.h"

namespace candela::flatten {

struct LightTable;

/// A node, to the last bit as the specification defines it.
struct LightNode {
  glm::vec3 centre{0};
  float radius = 0;
  float power = 0;         ///< of all lights of the tree it is 1, apart from rounding
  std::uint32_t axis = 0;  ///< stored direction, and gpu::kLightNodeCosine and kLightNodeTwoSided
  float cosine = -1;       ///< o
  /// The light of a leaf: its entry in the table, or in the tree of a mesh the triangle. An inner node: see
  /// LightTree::inner.
  std::uint32_t next = 0;
};
static_assert(sizeof(LightNode) == 32);

/// The nodes of a tree over n > 0 lights.
struct LightTree {
  std::vector<LightNode> leaves;  ///< n, in the order of the tree
  /// n - 1; the first one is the root. `next` is the first leaf m of the right range. The left range is leaf m - 1 if
  /// gpu::kLightNodeLeftLeaf is set in `next`, else inner node m - 1; the right range is leaf m if
  /// gpu::kLightNodeRightLeaf is set, else inner node m.
  std::vector<LightNode> inner;
};

/// Builds the tree over the entries of a table that are `inTree`, at least one, and sets their trails; and the trees of
/// its meshes. With `oneSided`, triangles emit only from their front.
LightTree buildLightTree(const scene::Scene& scene, LightTable& table, bool oneSided);

}  // namespace candela::flatten

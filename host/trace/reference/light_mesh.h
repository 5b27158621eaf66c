// Meshes whose triangles emit, and the instances that show them: docs/light-transport.md section 6.1.
#pragma once
#include <cstdint>
#include <limits>
#include <optional>
#include <tuple>
#include <vector>

#include "host/scene/scene.h"
#include "host/trace/reference/light_tree.h"

namespace candela::reference {

/// The triangles of a mesh with one material, as instances show them whose placements all mirror, or of which none
/// does.
class LightMesh {
 public:
  /// `run` is one of the instances. With `oneSided`, triangles emit only from their front.
  LightMesh(const scene::Scene& scene, const scene::PrimitiveRun& run, bool oneSided);

  /// Equal for the instances of a mesh.
  using Key = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t, bool>;
  static Key keyOf(const scene::Scene& scene, const scene::PrimitiveRun& run);

  /// A triangle of the mesh that the tree has.
  struct Part {
    std::uint32_t triangle;
    double luminance;  ///< of its emission
  };
  const std::vector<Part>& parts() const { return parts_; }
  /// The tree over the parts; none if there are no parts.
  const std::optional<LightTree>& tree() const { return tree_; }
  /// Returns the index of a triangle in the tree; none if it is not there.
  std::optional<std::uint32_t> indexInTree(std::uint32_t triangle) const;

 private:
  std::vector<Part> parts_;
  std::optional<LightTree> tree_;
};

/// An instance of such a mesh.
class LightInstance {
 public:
  /// `mesh`: that of the instance, by its index among all.
  LightInstance(const scene::Scene& scene, const scene::PrimitiveRun& run, const LightMesh& mesh,
                std::uint32_t meshIndex, bool oneSided);

  std::uint32_t firstPrimitive() const { return firstPrimitive_; }
  std::uint32_t mesh() const { return mesh_; }
  /// The sum of the weights of its triangles.
  double power() const { return power_; }
  /// The node of the light tree, without its power. Requires a positive power.
  const LightBounds& bounds() const { return bounds_; }
  /// Returns a receiver in the space of the mesh.
  PlacedReceiver receiverInMesh(const LightReceiver& receiver) const;

 private:
  std::uint32_t firstPrimitive_;
  std::uint32_t mesh_;
  double power_ = 0;
  LightBounds bounds_;
  glm::dmat3 linear_;
  dvec3 translation_;
  glm::dmat3 inverse_;
  double condition_;
};

}  // namespace candela::reference

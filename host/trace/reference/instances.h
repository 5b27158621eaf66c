// Instances of meshes, which rays find by two levels of BVHs: docs/light-transport.md section 4.1.
#pragma once
#include <cstdint>
#include <vector>

#include "host/scene/scene.h"
#include "host/trace/reference/hierarchy.h"
#include "host/trace/reference/hierarchy_traversal.h"
#include "host/trace/reference/ray.h"
#include "host/trace/render/settings.h"

namespace candela::reference {

/// A run of triangles that shows a mesh at a placement A x + b. Boxes of the mesh are tested with the ray in the space
/// of the mesh, in which it has the distances t that it has in the scene, and triangles with their vertices placed. The
/// padding keeps the first from losing a hit of the second. With u = 2^-24, |.| for the largest coordinate or, of a
/// matrix, the largest sum of the magnitudes of a row, P_j for the largest magnitude of coordinate j in the mesh, and R
/// for the largest of sum_j |A_ij| P_j + |b_i|:
///
/// - A placed vertex is the result of a product and three sums in each of its terms, so that its coordinates differ
/// from
///   those of A p + b by less than 5 u R, and by 2^-147 where products are subnormal. Each point of the placed triangle
///   is a mean of its vertices. It differs by no more than these from A y + b, where y is the mean of the vertices in
///   the mesh with the same weights, and in the triangle's box.
/// - A hit, as it is computed, is within the widening of boundsOf(), at most kWidening R, of a point of the placed
///   triangle. Where a hit may be outside of the triangle (see Tracing), it is within the padding of the scene's boxes.
///
/// The inverse maps a hit to y and |A^-1| times these distances. The computed inverse W is applied as W (o - b) and
/// W d, with errors of some 2^-51 |W| (|o| + R), for which the widening has the same room as in the scene. At the
/// condition numbers of placements, W A differs from the identity by less than 2^-25 (the square of the condition
/// number times 2^-50), for which the 4 u of four roundings leave room below 5 u.
class Instance {
 public:
  /// `mesh`: index of the hierarchy of its mesh, with these bounds.
  Instance(const scene::Scene& scene, const scene::PrimitiveRun& run, std::uint32_t mesh, const Bounds& meshBounds);

  const scene::PrimitiveRun& run() const { return run_; }
  std::uint32_t mesh() const { return mesh_; }
  /// Returns whether the placement has an inverse, which too small numbers may lack.
  bool isInvertible() const;
  /// Returns a box of the placed triangles, widened as that of boundsOf().
  const Bounds& bounds() const { return bounds_; }
  /// Returns the ray in the space of the mesh. `scenePadding`: that of boxes in the scene.
  BoxRay rayInMesh(const Ray& ray, double scenePadding) const {
    return {toMesh_ * (ray.origin - translation_), toMesh_ * ray.direction, stretch_ * (padding_ + scenePadding)};
  }

 private:
  scene::PrimitiveRun run_;
  std::uint32_t mesh_;
  glm::dmat3 toMesh_;
  dvec3 translation_;
  double stretch_;  ///< the largest sum of the magnitudes of a row of toMesh_
  double padding_;  ///< in the scene, without that of its boxes
  Bounds bounds_;
};

/// The runs of a scene that scene::isInstance() names.
class Instances {
 public:
  Instances() = default;
  Instances(const scene::Scene& scene, render::BvhSplit split);

  bool empty() const { return instances_.empty(); }
  const std::vector<Instance>& instances() const { return instances_; }
  std::size_t nodeCount() const;
  /// Returns whether a run of Scene::primitives, given by its index, is one of these instances.
  bool contains(std::size_t run) const { return !empty() && isInstance_[run]; }
  /// Builds the BVH over the instances, whose boxes are padded. Has to be called before visit().
  void build(double padding);

  /// Calls visit(run, primitive) for triangles that a ray may hit before `limit`, which `visit` may reduce. Ends when
  /// `visit` returns true, and returns whether it did. There must be instances.
  template <class Visit>
  bool visit(const Ray& ray, const double& limit, std::uint64_t& steps, Visit&& visit) const {
    const auto visitInstance = [&](std::uint32_t position) {
      const Instance& instance = instances_[hierarchy_.order[position]];
      const Hierarchy& mesh = meshes_[instance.mesh()];
      return traverse(mesh, instance.rayInMesh(ray, padding_), limit, steps,
                      [&](std::uint32_t i) { return visit(instance.run(), instance.run().first + mesh.order[i]); });
    };
    return traverse(hierarchy_, {ray.origin, ray.direction}, limit, steps, visitInstance);
  }

 private:
  std::vector<Hierarchy> meshes_;  ///< over the boxes of triangles that are not placed
  std::vector<Instance> instances_;
  std::vector<bool> isInstance_;  ///< by run of Scene::primitives
  Hierarchy hierarchy_;           ///< over instances_
  render::BvhSplit split_ = render::BvhSplit::sah;
  double padding_ = 0;
};

}  // namespace candela::reference

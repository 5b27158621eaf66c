// The nodes of a file and where they are.
#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "host/gltf/animation.h"

namespace candela::gltf {

/// The transform of a node relative to its parent: its matrix, or T R S with quaternions of any length. Throws
/// PlaceError.
glm::dmat4 localTransform(const Value& node, const NodePose& pose);

/// Returns T R S for a quaternion of any length; length 0 means no rotation.
glm::dmat4 compose(const glm::dvec3& translation, const glm::dquat& rotation, const glm::dvec3& scale);

class NodeTree {
 public:
  /// Throws PlaceError where a node is its own ancestor or has two parents, or where a transform is wrong.
  NodeTree(const Value& root, const Pose& pose);

  /// From the node's coordinates to those of the scene.
  const glm::dmat4& world(std::size_t node) const { return worlds_[node]; }
  /// The nodes of the default scene, each after its parent and before its next sibling. Without any scene: all nodes.
  const std::vector<std::size_t>& visible() const { return visible_; }

 private:
  void collectChildren(const Value& root);
  std::vector<std::size_t> rootsOf(const Value& root) const;
  /// The nodes at and below some nodes, in the order of visible().
  std::vector<std::size_t> descend(const std::vector<std::size_t>& from) const;

  std::vector<std::vector<std::size_t>> children_;
  std::vector<bool> hasParent_;
  std::vector<glm::dmat4> worlds_;
  std::vector<std::size_t> visible_;
};

}  // namespace candela::gltf

// The nodes of a file and where they are.
#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "host/formats/gltf/animation.h"
#include "host/formats/gltf/node_transform.h"
#include "host/formats/loading/diagnostic_log.h"

namespace candela::gltf {

class NodeTree {
 public:
  /// Throws JsonError where a node is its own ancestor or has two parents, or where a transform is wrong. A scene that
  /// lists a node with a parent causes a warning if its ancestors do not move it; otherwise an error, or, with
  /// `lenient`, a warning: the node is then placed without them, as other viewers do.
  NodeTree(const Value& root, const Pose& pose, bool lenient, scene::DiagnosticLog& log);

  /// From the node's coordinates to those of the scene.
  const glm::dmat4& world(std::size_t node) const { return worlds_[node]; }
  /// The nodes of the default scene, each after its parent and before its next sibling. Without any scene: all nodes.
  const std::vector<std::size_t>& visible() const { return visible_; }
  /// Returns whether KHR_node_visibility hides what a node has, except a camera.
  bool isHidden(std::size_t node) const { return isHidden_[node]; }

 private:
  static constexpr std::size_t kNone = ~std::size_t{0};

  /// A second parent of a node is an error, or with `lenient` ignored with a warning.
  void collectChildren(const Value& root, bool lenient, scene::DiagnosticLog& log);
  /// Sets the transforms of the nodes at and below some nodes that are placed as if they had no parents. Returns these
  /// nodes, in the order of visible().
  std::vector<std::size_t> placeSubtrees(const std::vector<std::size_t>& tops, const Value& nodes, const Pose& pose);
  /// The entries of the default scene's list of nodes, without those below others of them, which cause a warning.
  std::vector<Value> listedRoots(const Value& root, const std::vector<std::size_t>& order,
                                 scene::DiagnosticLog& log) const;
  /// Returns the node of an entry of a scene's list. Accepts or refuses one that has a parent: see the constructor.
  std::size_t acceptRoot(const Value& entry, const Value& nodes, const Pose& pose, bool lenient,
                         scene::DiagnosticLog& log);
  /// The nodes at and below some nodes, in the order of visible().
  std::vector<std::size_t> descend(const std::vector<std::size_t>& from) const;

  std::vector<std::vector<std::size_t>> children_;
  std::vector<std::size_t> parents_;  ///< kNone of roots
  std::vector<bool> isHidden_;
  std::vector<glm::dmat4> worlds_;
  std::vector<std::size_t> visible_;
};

}  // namespace candela::gltf

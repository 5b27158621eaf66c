// The tree by which lights are chosen for a point: docs/light-transport.md section 6.1.
#pragma once
#include <cstdint>
#include <vector>

#include "host/trace/reference/light_bounds.h"
#include "host/trace/reference/vertex_numbers.h"

namespace candela::reference {

class Arithmetic;

class LightTree {
 public:
  /// `powers`: of the lights, > 0, apart from a common factor; those of the bounds are set. There is at least one
  /// light. `dimensions`: of the random numbers of vertex 1.
  LightTree(std::vector<LightBounds> lights, std::vector<double> powers,
            std::uint32_t dimensions = kLightTreeDimensions);

  /// Returns the bounds of the root of such a tree.
  static LightBounds boundsOf(std::vector<LightBounds> lights, const std::vector<double>& powers);

  /// A light, as an index into the lights of the constructor, and the probability of its choice.
  struct Choice {
    std::uint32_t light;
    double probability;
  };
  /// Each step is a decision of `arithmetic`.
  Choice choose(const PlacedReceiver& receiver, const VertexNumbers& u, Arithmetic& arithmetic) const;
  /// Returns the probability with which choose() returns a light.
  double probability(std::uint32_t light, const PlacedReceiver& receiver, Arithmetic& arithmetic) const;

  /// Decisions from the root to a light, a bit each, the lowest first.
  std::uint32_t trail(std::uint32_t light) const { return trails_[light]; }
  const std::vector<LightBounds>& lights() const { return lights_; }

  /// A node is a light or has two nodes below it.
  struct Node {
    std::uint32_t index;  ///< of a light, or of an inner node
    bool isLight;
  };
  struct Inner {
    LightBounds bounds;
    Node low, high;
  };
  Node root() const { return root_; }
  const std::vector<Inner>& inner() const { return inner_; }

 private:
  class Builder;

  LightTree() = default;
  void setLights(std::vector<LightBounds> lights, const std::vector<double>& powers);
  const LightBounds& boundsOf(Node node) const {
    return node.isLight ? lights_[node.index] : inner_[node.index].bounds;
  }
  /// Returns the number of words, of 2^32, that choose the lower node.
  std::uint64_t lowWords(const Inner& inner, const PlacedReceiver& receiver, Arithmetic& arithmetic) const;

  std::vector<LightBounds> lights_;
  std::vector<Inner> inner_;
  std::vector<std::uint32_t> trails_;
  Node root_{0, true};
  std::uint32_t dimensions_ = kLightTreeDimensions;
};

}  // namespace candela::reference

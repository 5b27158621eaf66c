// The table of the lights that are sampled: docs/light-transport.md section 6.
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <unordered_map>
#include <vector>

#include "host/scene/scene.h"
#include "host/scene/shape.h"
#include "host/trace/reference/light.h"
#include "host/trace/reference/light_tree.h"
#include "host/trace/render/settings.h"

namespace candela::reference {

/// An entry of the table, of an instance also one of its triangles, and the probability of choosing it.
struct LightChoice {
  std::uint32_t entry;
  double probability;
  std::uint32_t primitive;  ///< that emits; kNoPrimitive for a light that is not a primitive
};

class LightTable {
 public:
  /// Depends on `nextEventEstimation` and `oneSided` of the settings. The scene must outlive the object.
  LightTable(const scene::Scene& scene, const render::RenderSettings& settings);

  /// Returns whether there is a light of positive weight.
  bool canChoose() const { return !thresholds_.empty() && thresholds_.back() > 0; }
  /// Exclusive upper bounds of the 24-bit numbers that choose each entry.
  const std::vector<std::uint32_t>& thresholds() const { return thresholds_; }

  /// Chooses with the numbers of a vertex. Requires canChoose().
  LightChoice choose(const LightReceiver& receiver, const VertexNumbers& u, Arithmetic& arithmetic) const;
  /// Chooses by the 32-bit number of the light choice. Requires canChoose(), and that there is no tree.
  LightChoice choose(std::uint32_t word) const;
  /// Returns the choice of an entry that is not an instance, apart from its probability.
  LightChoice choiceOf(std::uint32_t entry) const { return {entry, 1, entries_[entry].primitive}; }
  /// Returns nothing if the light does not illuminate `surface` with these numbers, or is a copy of its primitive.
  std::optional<LightSample> sample(const LightChoice& choice, const Surface& surface, const dvec2& u) const;
  /// Returns the density, per solid angle and times the probability of the choice, with which light sampling chooses
  /// the hit of `ray`, which starts at `receiver`, on `surface`; 0 if the primitive is not in the table.
  double pdf(const Ray& ray, double distance, const Surface& surface, const LightReceiver& receiver,
             Arithmetic& arithmetic) const;
  /// Returns the probability with which an entry is chosen for `receiver`.
  double probability(std::uint32_t entry, const LightReceiver& receiver, Arithmetic& arithmetic) const;
  /// Returns the probability with which a primitive is chosen for `receiver`; 0 if it is not in the table.
  double probabilityOf(std::uint32_t primitive, const LightReceiver& receiver, Arithmetic& arithmetic) const;
  /// The tree, if the settings select one and the scene has lights for it.
  const std::optional<LightTree>& tree() const { return tree_; }
  const std::vector<LightMesh>& meshes() const { return meshes_; }
  /// Index in the tree of an entry of the table; none if it is not in the tree.
  std::optional<std::uint32_t> indexInTree(std::uint32_t entry) const;
  /// Returns whether an entry is the environment, which sample() does not sample.
  bool isEnvironment(std::uint32_t entry) const { return entry == entryOfEnvironment_; }
  /// Returns the probability of choosing the environment; 0 if it is not in the table.
  double environmentProbability() const;

 private:
  static constexpr std::uint32_t kNoEntry = 0xffffffffu;

  struct Entry {
    Light light;
    double weight;
    std::uint32_t primitive;  ///< kNoPrimitive for a light that is not a primitive
  };

  /// Adds the primitives of a run, which emit.
  void addEmitters(const scene::PrimitiveRun& run);
  /// Adds a primitive that emits.
  void addEmitter(std::uint32_t primitive, const scene::Primitive& emitter);
  void addInstance(const scene::PrimitiveRun& run);
  /// Returns the light of a triangle that is not in the table, but in an instance that is.
  TriangleLight triangleOfInstance(std::uint32_t primitive) const;
  /// Returns the entry of a primitive, or of its instance; kNoEntry if there is none.
  std::uint32_t entryOf(std::uint32_t primitive) const;
  /// Returns the instance of an entry; null if it is none.
  const LightInstance* instanceOf(std::uint32_t entry) const;
  /// Returns the index of the entry.
  std::uint32_t add(const Light& light, std::uint32_t primitive = kNoPrimitive);
  bool isOnCopy(std::uint32_t primitive, const Surface& surface) const;
  void buildTree();
  /// Sums of the entries' weights.
  std::vector<double> groupWeights() const;
  /// The probability of each group that has an entry of positive weight.
  std::vector<double> groupProbabilities() const;
  /// Raises the weights of lights that no ray finds, so that none is lost beside a much brighter one.
  void raisePointWeights();
  void computeThresholds(const std::vector<double>& groups);
  double probability(std::uint32_t entry) const;
  double treeProbability() const { return treeThreshold_ * 0x1p-24; }

  const scene::Scene* scene_;
  render::LightSelection selection_;
  bool oneSided_;
  std::optional<LightTree> tree_;
  std::vector<std::uint32_t> entriesOfTree_;  // ascending
  std::vector<Entry> entries_;
  std::uint32_t treeThreshold_ = 0;
  std::vector<std::uint32_t> thresholds_;
  std::unordered_map<std::uint32_t, std::uint32_t> entryOfPrimitive_;
  std::vector<LightMesh> meshes_;
  std::vector<LightInstance> instances_;
  std::map<LightMesh::Key, std::uint32_t> meshOfKey_;
  std::map<std::uint32_t, std::uint32_t> entryOfInstance_;  // by the first primitive
  std::uint32_t entryOfEnvironment_ = kNoEntry;
};

}  // namespace candela::reference

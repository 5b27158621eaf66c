// Builds a scene from the nodes of a glTF file.
#pragma once
#include <map>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "host/formats/gltf/cameras.h"
#include "host/formats/gltf/geometry.h"
#include "host/formats/gltf/nodes.h"
#include "host/formats/gltf/shared_mesh.h"
#include "host/formats/gltf/textures.h"
#include "host/formats/loading/diagnostic_log.h"
#include "host/formats/loading/load.h"

namespace candela::gltf {

/// Adds materials, meshes and lights to a scene. Errors are collected in the log, each with its place.
class SceneAssembly {
 public:
  /// All must outlive this object. `lenient` is that of the options. `decoded` is that of Textures.
  SceneAssembly(const Value& root, const NodeTree& nodes, const Pose& pose, Accessors& accessors, Buffers& buffers,
                bool lenient, DecodedImages* decoded, scene::DiagnosticLog& log);

  void addMaterials();
  /// Adds the meshes and lights of the visible nodes, in the order of NodeTree::visible(). Call addMaterials() first.
  void addNodes();
  /// Removes the opacity of materials that every ray hits. Call addNodes() first.
  void dropUselessOpacity();
  /// Adds warnings about everything that was omitted.
  void reportOmissions();

  scene::Scene& scene() { return scene_; }
  const scene::StatementCounts& counts() const { return counts_; }
  const Textures& textures() const { return textures_; }
  /// Returns whether a material has an occlusion texture, which is not used.
  bool hasOcclusion() const { return hasOcclusion_; }
  /// Returns the bounds of all vertices of triangles; nothing if there are none.
  std::optional<scene::Bounds> bounds() const;

 private:
  void addNode(std::size_t index);
  Value meshOf(const Value& node) const;
  /// Names the object whose primitives begin at `first`; no object if there are none.
  void addObject(const Value& node, std::size_t index, std::size_t first);
  void addMesh(const Value& node, std::size_t index);
  void addPrimitive(const Value& node, std::size_t index, const Value& mesh, const Value& primitive);
  /// Adds a mesh that nothing else shows, where a map places it.
  void addPlaced(scene::Mesh mesh, const glm::dmat4& map, std::uint32_t material, const Value& source);
  /// Adds the instances at a node of a primitive that is shown more than once.
  void addInstances(const Value& node, std::size_t index, const Value& primitive, std::span<const double> weights,
                    SharedMesh& shared);
  std::uint32_t storeShared(const Value& source, scene::Mesh mesh);
  /// Reads the triangles of a primitive, with tangents if its material needs them; nothing if it has no positions.
  /// `influences`: of a primitive that is skinned, those of its vertices.
  std::optional<scene::Mesh> readMesh(const Value& primitive, std::span<const double> weights, std::uint32_t material,
                                      Influences* influences = nullptr);
  std::string keyOf(const Value& primitive, std::span<const double> weights) const;
  /// Counts how often each primitive is shown.
  void countUses();
  void addLight(const Value& node, std::size_t index);
  /// Counts triangles and memory before they are added, and throws JsonError or OutOfMemoryError if there are too many.
  void requireRoom(const Value& source, std::uint64_t triangles, std::uint64_t bytes);
  /// One transform relative to the node for each instance; only the identity without EXT_mesh_gpu_instancing.
  std::vector<glm::dmat4> instancesOf(const Value& node);
  std::vector<double> morphWeights(const Value& node, std::size_t index, const Value& mesh) const;
  std::uint32_t materialOf(const Value& primitive);
  void noteAlpha(float minAlpha, std::uint32_t material);
  /// Runs an action; an error becomes an entry of the log.
  template <class Action>
  void attempt(const Action& action);

  Value root_;
  const NodeTree& nodes_;
  const Pose& pose_;
  Accessors& accessors_;
  Buffers& buffers_;
  scene::DiagnosticLog& log_;
  Textures textures_;
  scene::Scene scene_{};
  scene::StatementCounts counts_{};
  std::set<std::string> unread_{};  ///< names of features of materials and meshes that are not rendered
  bool hasOcclusion_ = false;
  std::map<std::string, SharedMesh> shared_{};  ///< by geometryKey()
  std::map<std::uint32_t, float> minAlpha_{};   ///< of the vertex colours, by material
  std::size_t defaultMaterial_ = 0;             ///< its index, once it exists
  std::size_t triangleCount_ = 0;
  std::uint64_t byteCount_ = 0;
};

}  // namespace candela::gltf

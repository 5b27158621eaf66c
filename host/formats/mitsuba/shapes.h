// Shapes as primitives of the scene.
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "host/formats/mitsuba/bsdfs.h"
#include "host/formats/mitsuba/mesh_files.h"
#include "host/scene/scene.h"

namespace candela::mitsuba {

/// Adds shapes with their materials, and names the objects of the scene.
class Shapes {
 public:
  Shapes(const scene::SceneFile& file, const Description& description, scene::PathGuard& guard, Textures& textures,
         Report& report, scene::Scene& scene)
      : file_(file),
        description_(description),
        guard_(guard),
        textures_(textures),
        bsdfs_(textures, description.isOld, report),
        report_(report),
        scene_(scene) {}

  /// Adds a shape, or the shapes of an instance. A group is added where instances refer to it. Throws PlacedError,
  /// SceneError, and OutOfMemoryError if the scene needs more memory than the budget.
  void add(const Object& shape);

  /// Continues `hash` over the bytes of all files that were read.
  std::uint64_t hashFiles(std::uint64_t hash) const;

 private:
  /// The material of a shape and what it needs.
  struct Look {
    std::uint32_t material = 0;
    bool isInvisible = false;
    bool emits = false;
    bool needsTriangles = false;  ///< of textures, of an opacity, and of tangents
    bool transmits = false;
    std::optional<MeshAttribute> attribute{};
  };
  /// A mesh in its own coordinates.
  struct StoredMesh {
    scene::Mesh mesh{};
    double reach = 0;                         ///< its largest coordinate in magnitude
    std::optional<std::uint32_t> shared{};    ///< in Scene::meshes, once an instance needed it
    std::optional<std::uint32_t> mirrored{};  ///< of the mesh for placements that mirror
  };

  void addLeaf(const Object& shape, const glm::dmat4& map, bool isInstance);
  Look lookOf(const Object& shape, bool isInstance);
  std::uint32_t addMaterial(const Object* bsdf, const Object* emitter, const Object& shape, Look& look);
  std::uint32_t storeMaterial(const Bsdf& bsdf, const Texture& emission, const std::string& name);
  bool addRound(const Object& shape, const glm::dmat4& map, const Look& look);
  void addSphere(const Object& shape, const glm::dmat4& map, bool isFlipped, const Look& look);
  void addCylinder(const Object& shape, const glm::dmat4& map, bool isFlipped, const Look& look);
  glm::dmat4 ownMap(const Object& shape) const;
  StoredMesh* meshOf(const Object& shape, const Look& look);
  scene::Mesh readFile(const Object& shape, const std::filesystem::path& path, const MeshFileOptions& options);
  void finish(scene::Mesh& mesh, const Look& look) const;
  void addPlaced(scene::Mesh mesh, const glm::dmat4& map, const Object& shape, const Look& look);
  void addInstance(StoredMesh& stored, const glm::dmat4& map, const Object& shape, const Look& look);
  void addBacking(const scene::Mesh& mesh, const Object& shape, const Look& look);
  std::uint32_t blackMaterial();
  void beginObject(const Object& shape);
  void requireRoom(const Object& shape, std::uint64_t triangles, std::uint64_t bytes);

  const scene::SceneFile& file_;
  const Description& description_;
  scene::PathGuard& guard_;
  Textures& textures_;
  Bsdfs bsdfs_;
  Report& report_;
  scene::Scene& scene_;
  std::map<std::pair<const Object*, const Object*>, Look> materials_{};  ///< by BSDF and emitter
  std::map<std::string, std::optional<StoredMesh>> meshes_{};            ///< empty: the file cannot be read
  std::optional<std::uint32_t> black_{};
  std::vector<std::uint64_t> hashes_{};
  std::uint64_t byteCount_ = 0, triangleCount_ = 0, shapeCount_ = 0, materialCount_ = 0;
};

}  // namespace candela::mitsuba

// Makes meshes of runs of triangles.
#include "host/formats/obj/obj_meshes.h"

#include <map>
#include <tuple>
#include <vector>

#include "host/formats/loading/mikk_tangents.h"
#include "host/formats/loading/scene_builder.h"
#include "host/formats/loading/vertex_normals.h"
#include "host/formats/obj/corner_table.h"

namespace candela::obj {
namespace {

/// Runs with equal keys share a mesh: the material in the scene, whether there are texture coordinates and normals.
using Key = std::tuple<std::uint32_t, bool, bool>;

/// The triangles of a run in the scene.
struct PlacedRun {
  std::uint32_t mesh = 0;
  std::uint32_t firstTriangle = 0;
  std::uint32_t triangleCount = 0;
};

std::size_t endOf(const ObjModel& model, std::size_t run) {
  return run + 1 < model.runs.size() ? model.runs[run + 1].firstCorner : model.corners.size();
}

/// Gathers the attributes of the vertices of a table.
scene::Mesh attributesOf(const ObjModel& model, const Run& form, const std::vector<Corner>& vertices) {
  scene::Mesh mesh;
  mesh.positions.reserve(vertices.size());
  for (const Corner& vertex : vertices) mesh.positions.push_back(model.positions[vertex.position]);
  if (!model.colours.empty()) {
    for (const Corner& vertex : vertices) mesh.colours.emplace_back(model.colours[vertex.position], 1.0f);
  }
  if (form.hasTexCoords) {
    mesh.texCoords[0].reserve(vertices.size());
    for (const Corner& vertex : vertices) mesh.texCoords[0].push_back(model.texCoords[vertex.texCoord]);
  }
  if (form.hasNormals) {
    mesh.normals.reserve(vertices.size());
    for (const Corner& vertex : vertices) {
      mesh.normals.push_back(vertex.normal < ObjModel::kSmooth
                                 ? scene::unitNormalOrZero(glm::dvec3(model.normals[vertex.normal]))
                                 : model.smoothNormals.at(vertex.normal - ObjModel::kSmooth));
    }
  }
  return mesh;
}

class MeshAssembly {
 public:
  MeshAssembly(const ObjModel& model, std::span<const std::uint32_t> materials, scene::Scene& scene)
      : model_(model),
        materials_(materials),
        scene_(scene),
        table_(model.positions.size()),
        placed_(model.runs.size()) {}

  void add() {
    std::map<Key, std::vector<std::size_t>> groups;
    for (std::size_t i = 0; i < model_.runs.size(); ++i) groups[keyOf(model_.runs[i])].push_back(i);
    for (const auto& [key, runs] : groups) addMesh(runs);
    addPrimitives();
  }

 private:
  Key keyOf(const Run& run) const { return {materialOf(run), run.hasTexCoords, run.hasNormals}; }

  std::uint32_t materialOf(const Run& run) const {
    return run.material == kNone ? static_cast<std::uint32_t>(scene_.materials.size() - 1) : materials_[run.material];
  }

  /// Adds the mesh of some runs with equal keys.
  void addMesh(const std::vector<std::size_t>& runs) {
    const Run& form = model_.runs[runs.front()];
    std::vector<std::uint32_t> indices;
    table_.beginMesh();
    const auto meshIndex = static_cast<std::uint32_t>(scene_.meshes.size());
    for (const std::size_t run : runs) {
      const std::size_t first = model_.runs[run].firstCorner, end = endOf(model_, run);
      placed_[run] = {meshIndex, static_cast<std::uint32_t>(indices.size() / 3),
                      static_cast<std::uint32_t>((end - first) / 3)};
      for (std::size_t corner = first; corner < end; ++corner) {
        indices.push_back(table_.vertexOf(model_.corners[corner]));
      }
    }
    scene::Mesh mesh = attributesOf(model_, form, table_.vertices());
    mesh.indices = std::move(indices);
    if (form.hasNormals) scene::replaceZeroNormals(mesh);
    const auto& tangentTexture = tangentTextureOf(scene_.materials[materialOf(form)]);
    if (tangentTexture && form.hasTexCoords) scene::addMikkTangents(mesh, *tangentTexture);
    scene::storeMesh(scene_, std::move(mesh));
  }

  void addPrimitives() {
    std::uint32_t object = kNone;
    for (std::size_t i = 0; i < placed_.size(); ++i) {
      const Run& run = model_.runs[i];
      if (placed_[i].triangleCount == 0) continue;
      if (run.object != object) {
        object = run.object;
        scene_.objectStarts.push_back(static_cast<std::uint32_t>(scene_.primitives.size()));
        scene_.objectNames.push_back(model_.objectNames[object]);
      }
      scene_.primitives.append(
          {scene::PrimitiveKind::triangle, placed_[i].firstTriangle, materialOf(run), placed_[i].mesh},
          placed_[i].triangleCount);
    }
  }

  const ObjModel& model_;
  std::span<const std::uint32_t> materials_;
  scene::Scene& scene_;
  CornerTable table_;
  std::vector<PlacedRun> placed_;
};

}  // namespace

void addMeshes(const ObjModel& model, std::span<const std::uint32_t> materials, scene::Scene& scene) {
  MeshAssembly(model, materials, scene).add();
}

}  // namespace candela::obj

// The table by which next-event estimation chooses lights: docs/light-transport.md section 6.
#pragma once
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "host/scene/scene.h"
#include "host/trace/flatten/light_tree.h"
#include "host/trace/render/settings.h"
#include "lists/light_kinds.h"

namespace candela::flatten {

/// The kinds of lights that have entries: those of CANDELA_LIGHT_KINDS, with their values.
enum class LightKind : std::uint32_t {
#define CANDELA_ENUMERATE_KIND(kind, feature, name, value) kind = value,
  CANDELA_LIGHT_KINDS(CANDELA_ENUMERATE_KIND)
#undef CANDELA_ENUMERATE_KIND
};

/// The triangles of a mesh that emit, which instances share: docs/light-transport.md section 6.1.
struct LightMesh {
  scene::Primitive start;             ///< the first triangle, without a placement
  bool mirrors;                       ///< whether the placements of its instances do
  std::vector<double> luminances;     ///< of the emission, a triangle each
  std::vector<double> intensities;    ///< of the triangles in the space of the mesh; 0: not in the tree
  std::vector<std::uint32_t> trails;  ///< in the tree; gpu::kNoTrail if it is not there
  LightTree tree;                     ///< `next` of leaves: the triangle
};

struct LightEntry {
  static constexpr std::uint32_t kNoMesh = std::numeric_limits<std::uint32_t>::max();

  LightKind kind = LightKind::sphere;
  /// Primitive index, of an instance that of its first triangle; or index into Scene::pointLights or punctualLights.
  std::uint32_t index = 0;
  double power = 0;             ///< as lightPower() returns it
  std::uint32_t threshold = 0;  ///< T_i, in units of 2^-24
  float probability = 0;        ///< P_i, exact; 0 for a light of the tree
  bool inTree = false;
  std::uint32_t mesh = kNoMesh;  ///< of an instance that emits: index into LightTable::meshes
  /// Trail in the light tree; gpu::kNoTrail for a light of no power. Absent of lights that no tree has.
  std::optional<std::uint32_t> trail{};

  bool isInstance() const { return mesh != kNoMesh; }
  bool isEmitter() const { return kind < LightKind::point; }
  bool isPoint() const { return kind == LightKind::point; }
  bool isPunctual() const { return kind > LightKind::point && kind < LightKind::environment; }
  bool isEnvironment() const { return kind == LightKind::environment; }
};

struct LightTable {
  std::vector<LightEntry> entries;
  std::vector<LightMesh> meshes;    ///< their trees are empty until buildLightTree() builds them
  std::uint32_t treeThreshold = 0;  ///< T of the light tree in units of 2^-24; 0: there is none

  bool hasTree() const { return treeThreshold > 0; }
};

/// Returns the table. Without `withEmitters` (--nee off), it contains only point and punctual lights.
LightTable buildLightTable(const scene::Scene& scene, bool withEmitters,
                           render::LightSelection selection = render::LightSelection::power);

/// Numbers of lights of positive power whose probability is 0 because it is less than the resolution of the thresholds.
struct UnsampledLights {
  std::size_t emitters = 0;  ///< which rays find
  std::size_t others = 0;    ///< whose light is lost
};
UnsampledLights unsampledLights(const LightTable& table);

/// Returns the vertices of a triangle of a mesh, in its space.
scene::Triangle triangleOf(const scene::Scene& scene, const LightMesh& mesh, std::uint32_t triangle);

/// Weight of a light that is not an instance in the choice within its group.
double lightPower(const scene::Scene& scene, LightKind kind, std::uint32_t index);

/// Area of a triangle, in double.
double triangleArea(const scene::Triangle& triangle);

}  // namespace candela::flatten

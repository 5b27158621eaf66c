// The table by which next-event estimation chooses lights: docs/light-transport.md section 6.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "host/scene/scene.h"
#include "host/trace/render/settings.h"
#include "lists/light_kinds.h"

namespace candela::flatten {

/// The kinds of lights that have entries: those of CANDELA_LIGHT_KINDS, with their values.
enum class LightKind : std::uint32_t {
#define CANDELA_ENUMERATE_KIND(kind, feature, name, value) kind = value,
  CANDELA_LIGHT_KINDS(CANDELA_ENUMERATE_KIND)
#undef CANDELA_ENUMERATE_KIND
};

struct LightEntry {
  LightKind kind = LightKind::sphere;
  std::uint32_t index = 0;      ///< primitive index, or index into Scene::pointLights or punctualLights
  double power = 0;             ///< as lightPower() returns it
  std::uint32_t threshold = 0;  ///< T_i, in units of 2^-24
  float probability = 0;        ///< P_i, exact; 0 for a light of the tree
  bool inTree = false;
  /// Trail in the light tree; gpu::kNoTrail for a light of no power. Absent of lights that no tree has.
  std::optional<std::uint32_t> trail{};

  bool isEmitter() const { return kind < LightKind::point; }
  bool isPoint() const { return kind == LightKind::point; }
  bool isPunctual() const { return kind > LightKind::point && kind < LightKind::environment; }
  bool isEnvironment() const { return kind == LightKind::environment; }
};

struct LightTable {
  std::vector<LightEntry> entries;
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

/// Weight of a light in the choice within its group.
double lightPower(const scene::Scene& scene, LightKind kind, std::uint32_t index);

/// Area of a triangle, in double.
double triangleArea(const scene::Triangle& triangle);

}  // namespace candela::flatten

// The table by which next-event estimation chooses lights: docs/light-transport.md section 6.
#pragma once
#include <cstdint>
#include <vector>

#include "host/scene/scene.h"
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
  std::uint32_t threshold = 0;  ///< T_i, in units of 2^-24
  float probability = 0;        ///< P_i, exact

  bool isEmitter() const { return kind < LightKind::point; }
  bool isPoint() const { return kind == LightKind::point; }
  bool isPunctual() const { return kind > LightKind::point && kind < LightKind::environment; }
  bool isEnvironment() const { return kind == LightKind::environment; }
};

/// Returns the table. Without `withEmitters` (--nee off), it contains only point and punctual lights.
std::vector<LightEntry> buildLightTable(const scene::Scene& scene, bool withEmitters);

/// Weight of a light in the choice within its group.
double lightPower(const scene::Scene& scene, LightKind kind, std::uint32_t index);

/// Area of a triangle, in double.
double triangleArea(const scene::Triangle& triangle);

}  // namespace candela::flatten

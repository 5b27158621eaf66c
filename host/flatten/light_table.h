// The table from which next-event estimation chooses: docs/light-transport.md section 6.
#pragma once
#include <cstdint>
#include <vector>

#include "host/scene/scene.h"

namespace candela::flatten {

struct LightEntry {
  bool isPoint = false;
  std::uint32_t index = 0;      ///< primitive index, or index into Scene::pointLights
  std::uint32_t threshold = 0;  ///< T_i, in units of 2^-24
  float probability = 0;        ///< P_i, exact
};

/// `withEmitters` false leaves point lights only (--nee off).
std::vector<LightEntry> buildLightTable(const scene::Scene& scene, bool withEmitters);

/// Area of a triangle, in double.
double triangleArea(const scene::Triangle& triangle);

}  // namespace candela::flatten

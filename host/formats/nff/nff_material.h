// The `f` line of NFF and P3F, and the rules that convert it to a material.
#pragma once
#include <span>

#include "host/scene/material.h"

namespace candela::scene {

/// An `f` line. Values that its dialect lacks have the defaults given here. All numbers are >= 0.
struct NffMaterial {
  glm::vec3 diffuse{1, 1, 1};
  float kd = 1;
  glm::vec3 specular{1, 1, 1};
  float ks = 0;
  float shine = 1;  ///< Blinn-Phong exponent
  float t = 0;      ///< fraction of transmitted light
  float ior = 1;
  float ka = 0;         ///< ambient light; Whitted tracer only
  float roughness = 0;  ///< not used
  glm::vec3 emission{0, 0, 0};
};

/// Assigns the numbers of an `f` line by the dialect that their count determines (docs/scene-format.md). There must be
/// 8, 9, 11, 12, 14 or 15 of them, or 3 to 7 of an incomplete line.
NffMaterial readNffMaterial(std::span<const float> numbers);

/// Applies the rules of docs/light-transport.md section 5, and those of the Whitted tracer (section 9).
Material fromNff(const NffMaterial& line);

}  // namespace candela::scene

// The `f` line of NFF and P3F, and the rules that turn it into a material.
#pragma once
#include <span>

#include "host/scene/material.h"

namespace candela::scene {

/// An `f` line. A value that its dialect lacks has the default here. All numbers are >= 0.
struct NffMaterial {
  glm::vec3 diffuse{1, 1, 1};
  float kd = 1;
  glm::vec3 specular{1, 1, 1};
  float ks = 0;
  float shine = 1;  ///< Blinn-Phong exponent
  float t = 0;      ///< share of transmitted light
  float ior = 1;
  float ka = 0;         ///< ambient light, Whitted's integrator only
  float roughness = 0;  ///< not used
  glm::vec3 emission{0, 0, 0};
};

/// Names the numbers of an `f` line by the dialect that their count determines (docs/scene-format.md). There are 8, 9,
/// 11, 12, 14 or 15 of them, or 3 to 7 of an incomplete line.
NffMaterial readNffMaterial(std::span<const float> numbers);

/// The rules of docs/light-transport.md section 5, and the reading of Whitted's integrator (section 9).
Material fromNff(const NffMaterial& line);

}  // namespace candela::scene

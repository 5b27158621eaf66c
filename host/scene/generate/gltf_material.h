// Materials of glTF as the generators state them.
#pragma once
#include "host/scene/generate/gltf_document.h"

namespace candela::generate {

/// The factors of a material, with the defaults of the generators.
struct MaterialFactors {
  glm::dvec3 colour{1};
  double metalness = 0;
  double roughness = 0.5;
  double transmission = 0;
  double ior = 1.5;
  double thickness = 0;   ///< of the body that transmits; 0: a thin wall
  double dispersion = 0;  ///< of the volume, 20 / Abbe number
  double clearcoat = 0;
  double clearcoatRoughness = 0;
  glm::dvec3 sheen{0};
  double sheenRoughness = 0;
  double film = 0;           ///< weight of a thin film
  double filmThickness = 0;  ///< in nanometres
  glm::dvec3 eta{0};         ///< complex index of refraction of a metal, eta + i kappa; 0: by its colour
  glm::dvec3 kappa{0};
  double anisotropy = 0;
  double anisotropyRotation = 0;   ///< in radians
  glm::dvec3 attenuation{1};       ///< colour that is left after `attenuationDistance`
  double attenuationDistance = 0;  ///< 0: nothing is absorbed
  glm::dvec3 emission{0};          ///< radiance
};

/// Returns the JSON object.
GltfDocument::Json gltfMaterial(const MaterialFactors& factors);

}  // namespace candela::generate

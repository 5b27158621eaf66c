// The parameters of a surface, with the names of OpenPBR 1.1: docs/light-transport.md section 5.1.
#pragma once
#include <glm/glm.hpp>
#include <optional>

namespace candela::scene {

/// The complex index of refraction ior + i extinction of a metal, for red, green and blue. `ior` > 0, `extinction` >=
/// 0.
struct Conductor {
  glm::vec3 ior{1, 1, 1};
  glm::vec3 extinction{0, 0, 0};

  bool operator==(const Conductor&) const = default;
};

/// Tracers turn the parameters into the weights of lobes at every hit. Colours are linear RGB in [0, 1], weights and
/// roughnesses are in [0, 1].
struct SurfaceParameters {
  glm::vec3 baseColour{1, 1, 1};
  float metalness = 0;
  glm::vec3 specularColour{1, 1, 1};  ///< factor of a dielectric's reflectance at normal incidence; may exceed 1
  float specularWeight = 1;           ///< of a dielectric's reflection at all angles
  float roughness = 1;                ///< perceptual: alpha is its square
  float ior = 1.5f;                   ///< of the inside relative to the outside, at least 1; or 0: reflects everything
  float transmissionWeight = 0;       ///< fraction of the diffuse reflection that is replaced by transmission
  float transmissionDispersionScale = 0;  ///< of a volume whose Abbe number is 20 divided by it; 0: no dispersion
  bool isThinWalled = true;               ///< the surface bounds no volume, and light passes it without refraction
  glm::vec3 absorption{0, 0, 0};          ///< coefficient of the volume, per unit of length in the scene, >= 0
  float coatWeight = 0;
  glm::vec3 sheenColour{0, 0, 0};  ///< albedo of the fibres on the surface, relative to that of white ones
  float sheenRoughness = 0;
  float coatRoughness = 0;
  float anisotropy = 0;                  ///< alpha along its direction is mix(alpha, 1, anisotropy^2)
  float anisotropyRotation = 0;          ///< of that direction from the tangent, counter-clockwise, in radians
  float filmWeight = 0;                  ///< of interference in a thin film on the surface
  float filmIor = 1.3f;                  ///< at least 1
  float filmThickness = 400;             ///< in nanometres
  float filmThicknessMinimum = 100;      ///< in nanometres, where a texture's thickness is 0
  std::optional<Conductor> conductor{};  ///< of the metal, which reflects by Fresnel's equations times the base colour

  /// The surface bounds a volume, which light enters and leaves by refraction.
  bool hasVolume() const { return !isThinWalled && transmissionWeight > 0; }

  /// The index of refraction differs between red, green and blue.
  bool disperses() const { return hasVolume() && transmissionDispersionScale > 0 && ior > 1; }

  bool operator==(const SurfaceParameters&) const = default;
};

}  // namespace candela::scene

// The parameters of a surface, with the names of OpenPBR 1.1: docs/light-transport.md section 5.1.
#pragma once
#include <glm/glm.hpp>
#include <optional>

#include "host/scene/interface.h"
#include "host/scene/plastic.h"
#include "lists/surface_parameters.h"

namespace candela::scene {

/// The complex index of refraction ior + i extinction of a metal, for red, green and blue. `ior` > 0, `extinction` >=
/// 0.
struct Conductor {
  glm::vec3 ior{1, 1, 1};
  glm::vec3 extinction{0, 0, 0};

  bool operator==(const Conductor&) const = default;
};

/// The entries of CANDELA_SURFACE_PARAMETERS, and what devices store in another form. Tracers turn the parameters into
/// the weights of lobes at every hit. Colours are linear RGB in [0, 1], weights and roughnesses are in [0, 1], unless
/// the list states another range.
struct SurfaceParameters {
#define CANDELA_DECLARE_COLOUR(name, value, record) glm::vec3 name{value};
#define CANDELA_DECLARE_NUMBER(name, value, record, lane) float name = value;
#define CANDELA_DECLARE_FLAG(name, value) bool name = value;
  CANDELA_SURFACE_PARAMETERS(CANDELA_DECLARE_COLOUR, CANDELA_DECLARE_NUMBER, CANDELA_DECLARE_FLAG)
#undef CANDELA_DECLARE_COLOUR
#undef CANDELA_DECLARE_NUMBER
#undef CANDELA_DECLARE_FLAG
  float anisotropyRotation = 0;          ///< of anisotropy's direction from the tangent, counter-clockwise, in radians
  std::optional<Conductor> conductor{};  ///< of the metal, which reflects by Fresnel's equations times the base colour

  /// Makes the base plastic: the base colour is that of its diffuse base, and the specular colour a factor of what its
  /// boundary reflects. Metalness, transmission, specular weight, anisotropy and film have their defaults or 0.
  std::optional<Plastic> plastic{};

  /// Makes the surface a single interface without compensation: one that transmits light if the transmission weight
  /// is above 0, whose reflection has the specular colour as a factor and whose transmission the base colour, or else
  /// a metal, which reflects everything without a conductor. Then `ior` may be any number above 0, but that of a rough
  /// interface differs from 1 by a factor of at least 1.01. Thin walls are smooth. Specular weight, plastic, coat,
  /// sheen, film and dispersion have their defaults.
  std::optional<Interface> bareInterface{};

  /// The surface bounds a volume, which light enters and leaves by refraction.
  bool hasVolume() const { return !isThinWalled && transmissionWeight > 0; }

  /// The surface is a perfect mirror or smooth glass: it scatters each direction only to one or two others.
  bool isPerfect() const {
    return bareInterface && (*bareInterface == Interface::smooth || (isThinWalled && transmissionWeight > 0));
  }

  /// The index of refraction differs between red, green and blue.
  bool disperses() const { return hasVolume() && transmissionDispersionScale > 0 && ior > 1; }

  bool operator==(const SurfaceParameters&) const = default;
};

}  // namespace candela::scene

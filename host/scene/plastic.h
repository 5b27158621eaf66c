// Plastic, a diffuse base below the boundary of a dielectric: docs/light-transport.md section 5.14.
#pragma once
#include <array>
#include <cstddef>

#include "host/scene/interface.h"

namespace candela::scene {

/// The properties of plastic beside a surface's colours, roughness and index of refraction. makePlastic() computes the
/// numbers from roughness and index, as tables that both tracers share.
struct Plastic {
  static constexpr std::size_t kNodes = 64;

  Interface boundary = Interface::smooth;  ///< above the base
  /// Light that is scattered inside several times takes the base's colour each time; otherwise, the base colour is that
  /// of all the light that leaves the base.
  bool isNonlinear = false;
  float internalReflectance = 0;  ///< of the boundary, for diffuse light from the base, in [0, 1)
  /// Fractions of the light from outside that a rough boundary transmits, at the cosines i / (kNodes - 1). Those of a
  /// smooth boundary are Fresnel's, and these are 0.
  std::array<float, kNodes> transmittances{};

  bool operator==(const Plastic&) const = default;
};

/// `roughness`: the surface's, whose square is the alpha of both distributions. `ior`: of the inside relative to the
/// outside, above 1. A rough boundary takes up to 0.1 s.
Plastic makePlastic(Interface boundary, float roughness, float ior, bool isNonlinear = false);

}  // namespace candela::scene

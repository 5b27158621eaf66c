// Plastic, a diffuse base below the boundary of a dielectric: docs/light-transport.md section 5.14.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

namespace candela::scene {

/// The boundary above the base: smooth, or rough with one of two distributions of normals.
enum class PlasticBoundary : std::uint8_t { smooth, ggx, beckmann };

/// The properties of plastic beside a surface's colours, roughness and index of refraction. makePlastic() computes the
/// numbers from roughness and index, as tables that both tracers share.
struct Plastic {
  static constexpr std::size_t kNodes = 64;

  PlasticBoundary boundary = PlasticBoundary::smooth;
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
Plastic makePlastic(PlasticBoundary boundary, float roughness, float ior, bool isNonlinear = false);

}  // namespace candela::scene

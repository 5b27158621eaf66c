// Colour maps for numbers.
#pragma once
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace candela::image {

/// Returns the colour map "magma" of matplotlib (Nathaniel Smith and Stefan van der Walt, CC0) at t as sRGB signals in
/// [0, 1]: a polynomial fit by Matt Zucker ("WlfXRN" on shadertoy.com, CC0). t is clamped to [0, 1]; NaN is taken as 0.
inline glm::dvec3 magma(double t) {
  const double x = std::isnan(t) ? 0 : std::clamp(t, 0.0, 1.0);
  constexpr glm::dvec3 c0(-0.002136485053939582, -0.000749655052795221, -0.005386127855323933);
  constexpr glm::dvec3 c1(0.2516605407371642, 0.6775232436837668, 2.494026599312351);
  constexpr glm::dvec3 c2(8.353717279216625, -3.577719514958484, 0.3144679030132573);
  constexpr glm::dvec3 c3(-27.66873308576866, 14.26473078096533, -13.64921318813922);
  constexpr glm::dvec3 c4(52.17613981234068, -27.94360607168351, 12.94416944238394);
  constexpr glm::dvec3 c5(-50.76852536473588, 29.04658282127291, 4.23415299384598);
  constexpr glm::dvec3 c6(18.65570506591883, -11.48977351997711, -5.601961508734096);
  return glm::clamp(c0 + x * (c1 + x * (c2 + x * (c3 + x * (c4 + x * (c5 + x * c6))))), 0.0, 1.0);
}

/// Returns sRGB signals for a signed value in [-1, 1]: black for 0, orange for 1, blue for -1.
inline glm::dvec3 signedColour(double strength) {
  constexpr glm::dvec3 kPositive(1, 0.55, 0.1);
  constexpr glm::dvec3 kNegative(0.15, 0.5, 1);
  return std::abs(strength) * (strength > 0 ? kPositive : kNegative);
}

}  // namespace candela::image

// The daylight of Preetham, Shirley and Smits, "A Practical Analytic Model for Daylight", SIGGRAPH 1999.
#pragma once
#include <glm/glm.hpp>

namespace candela::environment {

/// A clear or hazy sky with the sun above the horizon. Quantities are linear Rec. 709 colours whose luminance is in
/// kcd/m^2, and illuminances in klx.
class PreethamSky {
 public:
  /// `sunDirection` is a unit vector with y >= 0, `turbidity` from 2 to 10.
  PreethamSky(const glm::dvec3& sunDirection, double turbidity);

  /// Radiance of the sky, without the sun's disc, in a direction (unit vector) with y > 0. >= 0 in every channel.
  glm::dvec3 sky(const glm::dvec3& direction) const;
  /// Irradiance of a surface that faces the sun, by only its disc.
  glm::dvec3 sun() const;

 private:
  /// Perez' distribution of one quantity, relative to its value at the zenith.
  struct Perez {
    double a, b, c, d, e;

    double operator()(double cosTheta, double gamma, double cosGamma) const;
  };
  struct Quantity {
    Perez perez;
    double zenith;     ///< value at the zenith
    double reference;  ///< Perez' value there
  };

  double value(const Quantity& quantity, double cosTheta, double gamma, double cosGamma) const;

  glm::dvec3 sun_;
  double turbidity_;
  Quantity luminance_;
  Quantity x_;
  Quantity y_;
};

}  // namespace candela::environment

// The formulas of the paper's appendix A.2, and the extinction of sunlight of its appendix A.1.
#include "host/scene/environment/preetham.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candela::environment {
namespace {

using glm::dvec3;
using glm::dvec4;

using std::numbers::pi;
constexpr double kMinCosine = 0.01;  // the exponent B / cos theta has no limit at the horizon

// CIE xyY to linear Rec. 709 with its white point D65.
dvec3 toRec709(double x, double y, double luminance) {
  const double bigX = x / y * luminance;
  const double bigZ = (1 - x - y) / y * luminance;
  return {3.2404542 * bigX - 1.5371385 * luminance - 0.4985314 * bigZ,
          -0.9692660 * bigX + 1.8760108 * luminance + 0.0415560 * bigZ,
          0.0556434 * bigX - 0.2040259 * luminance + 1.0572252 * bigZ};
}

// A chromaticity at the zenith: a polynomial in turbidity and in the sun's distance from it, with the coefficients of
// t^3, t^2, t and 1 for T^2, T and 1.
double zenithChromaticity(double turbidity, double theta, const dvec4& square, const dvec4& linear,
                          const dvec4& constant) {
  const dvec4 powers(theta * theta * theta, theta * theta, theta, 1);
  return turbidity * turbidity * dot(square, powers) + turbidity * dot(linear, powers) + dot(constant, powers);
}

double zenithLuminance(double turbidity, double theta) {
  const double chi = (4.0 / 9 - turbidity / 120) * (pi - 2 * theta);
  return std::max((4.0453 * turbidity - 4.9710) * std::tan(chi) - 0.2155 * turbidity + 2.4192, 0.0);
}

// Fraction of sunlight of a wavelength (micrometres) that air molecules and aerosol let through; `mass` is the relative
// optical mass of the air.
double transmittance(double wavelength, double mass, double turbidity) {
  const double rayleigh = 0.008735 * std::pow(wavelength, -4.08);
  const double aerosol = (0.04608 * turbidity - 0.04586) * std::pow(wavelength, -1.3);
  return std::exp(-(rayleigh + aerosol) * mass);
}

}  // namespace

double PreethamSky::Perez::operator()(double cosTheta, double gamma, double cosGamma) const {
  return (1 + a * std::exp(b / std::max(cosTheta, kMinCosine))) *
         (1 + c * std::exp(d * gamma) + e * cosGamma * cosGamma);
}

PreethamSky::PreethamSky(const dvec3& sunDirection, double turbidity) : sun_(sunDirection), turbidity_(turbidity) {
  const double t = turbidity;
  const double cosine = std::clamp(sun_.y, 0.0, 1.0);
  const double theta = std::acos(cosine);
  luminance_.perez = {0.1787 * t - 1.4630, -0.3554 * t + 0.4275, -0.0227 * t + 5.3251, 0.1206 * t - 2.5771,
                      -0.0670 * t + 0.3703};
  x_.perez = {-0.0193 * t - 0.2592, -0.0665 * t + 0.0008, -0.0004 * t + 0.2125, -0.0641 * t - 0.8989,
              -0.0033 * t + 0.0452};
  y_.perez = {-0.0167 * t - 0.2608, -0.0950 * t + 0.0092, -0.0079 * t + 0.2102, -0.0441 * t - 1.6537,
              -0.0109 * t + 0.0529};
  luminance_.zenith = zenithLuminance(t, theta);
  x_.zenith = zenithChromaticity(t, theta, {0.00166, -0.00375, 0.00209, 0}, {-0.02903, 0.06377, -0.03202, 0.00394},
                                 {0.11693, -0.21196, 0.06052, 0.25886});
  y_.zenith = zenithChromaticity(t, theta, {0.00275, -0.00610, 0.00317, 0}, {-0.04214, 0.08970, -0.04153, 0.00516},
                                 {0.15346, -0.26756, 0.06670, 0.26688});
  for (Quantity* quantity : {&luminance_, &x_, &y_}) quantity->reference = quantity->perez(1, theta, cosine);
}

double PreethamSky::value(const Quantity& quantity, double cosTheta, double gamma, double cosGamma) const {
  return quantity.zenith * quantity.perez(cosTheta, gamma, cosGamma) / quantity.reference;
}

dvec3 PreethamSky::sky(const dvec3& direction) const {
  const double cosGamma = std::clamp(dot(direction, sun_), -1.0, 1.0);
  const double gamma = std::acos(cosGamma);
  const double luminance = std::max(value(luminance_, direction.y, gamma, cosGamma), 0.0);
  return max(toRec709(value(x_, direction.y, gamma, cosGamma), value(y_, direction.y, gamma, cosGamma), luminance),
             0.0);
}

dvec3 PreethamSky::sun() const {
  constexpr double kExtraterrestrial = 128;  // klx
  const dvec3 wavelengths(0.612, 0.549, 0.465);
  const double degrees = std::acos(std::clamp(sun_.y, 0.0, 1.0)) * 180 / pi;
  const double mass = 1 / (std::max(sun_.y, 0.0) + 0.15 * std::pow(93.885 - degrees, -1.253));
  return kExtraterrestrial * dvec3(transmittance(wavelengths.x, mass, turbidity_),
                                   transmittance(wavelengths.y, mass, turbidity_),
                                   transmittance(wavelengths.z, mass, turbidity_));
}

}  // namespace candela::environment

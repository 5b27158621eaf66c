// Colours filtered by contrast sensitivity, edges and points.
#include "host/image/flip_appearance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "host/image/flip_colour.h"

namespace candela::image {
namespace {

using glm::dvec3;
constexpr double kPi = std::numbers::pi;

/// Contrast sensitivity of one opponent channel: two Gaussians in frequency, weight a and scale b (table 1).
struct Sensitivity {
  double a1, b1, a2, b2;
};
constexpr std::array<Sensitivity, 3> kSensitivities = {{
    {1, 0.0047, 0, 1e-5},       // achromatic
    {1, 0.0053, 0, 1e-5},       // red-green
    {34.1, 0.04, 13.5, 0.025},  // blue-yellow
}};
constexpr double kMaxScale = 0.04;  ///< maximum of b

constexpr double kFeatureWidth = 0.082;  ///< w, degrees: two standard deviations of the edge detector

void add(Plane& sum, const Plane& term) {
  for (std::size_t i = 0; i < sum.values.size(); ++i) sum.values[i] += term.values[i];
}

/// Convolves with the filter a1 sqrt(pi/b1) exp(-pi^2 z^2/b1) + a2 sqrt(pi/b2) exp(-pi^2 z^2/b2) of the contrast
/// sensitivity (equation 2), z in degrees, normalised. Both Gaussians are negligible outside the radius. Each is
/// separable; their sum is not.
Plane filteredBySensitivity(const Plane& plane, const Sensitivity& s, double pixelsPerDegree) {
  const int radius = static_cast<int>(std::ceil(3 * std::sqrt(kMaxScale / (2 * kPi * kPi)) * pixelsPerDegree));
  const auto deviation = [&](double b) { return std::sqrt(b / 2) / kPi * pixelsPerDegree; };
  const Kernel first = gaussian(radius, deviation(s.b1));
  const Kernel second = gaussian(radius, deviation(s.b2));
  const double amplitude1 = s.a1 * std::sqrt(kPi / s.b1);
  const double amplitude2 = s.a2 * std::sqrt(kPi / s.b2);
  const double total = amplitude1 * sum(first) * sum(first) + amplitude2 * sum(second) * sum(second);
  Plane result = filtered(plane, scaled(first, amplitude1 / total), first);
  if (s.a2 > 0) add(result, filtered(plane, scaled(second, amplitude2 / total), second));
  return result;
}

/// Scales positive weights to the sum 1 and negative weights to the sum -1.
Kernel balanced(Kernel kernel) {
  double positive = 0;
  double negative = 0;
  for (const double weight : kernel) (weight > 0 ? positive : negative) += weight;
  for (double& weight : kernel) weight /= weight > 0 ? positive : -negative;
  return kernel;
}

/// Returns the length of the responses to a kernel along x and along y, both smoothed in the other direction.
Plane featureStrength(const Plane& plane, const Kernel& along, const Kernel& across) {
  Plane strength = filtered(plane, along, across);
  const Plane vertical = filtered(plane, across, along);
  for (std::size_t i = 0; i < strength.values.size(); ++i) {
    strength.values[i] = std::hypot(strength.values[i], vertical.values[i]);
  }
  return strength;
}

double clampedToDisplay(float value) { return std::isnan(value) ? 0 : std::clamp(double{value}, 0.0, 1.0); }

std::array<Plane, 3> opponentPlanes(const Image& image) {
  std::array<Plane, 3> planes;
  for (Plane& plane : planes) plane = {image.width, image.height, std::vector<double>(image.rgb.size())};
  for (std::size_t i = 0; i < image.rgb.size(); ++i) {
    const glm::vec3& rgb = image.rgb[i];
    const dvec3 opponent = flip::toOpponent(
        {clampedToDisplay(rgb.x), clampedToDisplay(rgb.y), clampedToDisplay(rgb.z)});
    for (std::size_t c = 0; c < 3; ++c) planes[c].values[i] = opponent[static_cast<glm::length_t>(c)];
  }
  return planes;
}

std::vector<dvec3> filteredColours(const std::array<Plane, 3>& opponent, double pixelsPerDegree) {
  std::array<Plane, 3> smooth;
  for (std::size_t c = 0; c < 3; ++c) {
    smooth[c] = filteredBySensitivity(opponent[c], kSensitivities[c], pixelsPerDegree);
  }
  std::vector<dvec3> colours;
  colours.reserve(smooth[0].values.size());
  for (std::size_t i = 0; i < smooth[0].values.size(); ++i) {
    const dvec3 linear = flip::fromOpponent({smooth[0].values[i], smooth[1].values[i], smooth[2].values[i]});
    colours.push_back(flip::toHuntLab(glm::clamp(linear, 0.0, 1.0)));
  }
  return colours;
}

}  // namespace

Appearance appearanceOf(const Image& image, double pixelsPerDegree) {
  const double deviation = 0.5 * kFeatureWidth * pixelsPerDegree;
  const int radius = static_cast<int>(std::ceil(3 * deviation));
  const Kernel across = gaussian(radius, deviation);
  Kernel edge = across;
  Kernel point = across;
  for (int x = -radius; x <= radius; ++x) {
    const auto i = static_cast<std::size_t>(x + radius);
    edge[i] *= -x;                                    // first derivative, up to a factor
    point[i] *= x * x / (deviation * deviation) - 1;  // second derivative, up to a factor
  }
  const Kernel smoothing = scaled(across, 1 / sum(across));

  const std::array<Plane, 3> opponent = opponentPlanes(image);
  Plane achromatic = opponent[0];
  for (double& value : achromatic.values) value = (value + 16) / 116;
  return {filteredColours(opponent, pixelsPerDegree), featureStrength(achromatic, balanced(edge), smoothing),
          featureStrength(achromatic, balanced(point), smoothing)};
}

}  // namespace candela::image

// LDR-FLIP: colours filtered by contrast sensitivity, edges and points, and their combination into one error.
#include "host/image/flip.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "host/core/errors.h"
#include "host/image/colour_map.h"
#include "host/image/flip_colour.h"
#include "host/image/separable_filter.h"

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
constexpr double kFeatureExponent = 0.5;

/// Returns exp(-x^2 / (2 deviation^2)) for -radius <= x <= radius.
Kernel gaussian(int radius, double deviation) {
  Kernel kernel;
  for (int x = -radius; x <= radius; ++x) kernel.push_back(std::exp(-x * x / (2 * deviation * deviation)));
  return kernel;
}

double sum(const Kernel& kernel) { return std::accumulate(kernel.begin(), kernel.end(), 0.0); }

Kernel scaled(Kernel kernel, double factor) {
  for (double& weight : kernel) weight *= factor;
  return kernel;
}

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

/// The properties of an image that FLIP compares.
struct Appearance {
  std::vector<dvec3> colours;  ///< Hunt-adjusted Lab after the low-pass filter of the eye
  Plane edges;
  Plane points;
};

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

double errorAt(const Appearance& test, const Appearance& reference, std::size_t i) {
  const double colour = flip::colourError(test.colours[i], reference.colours[i]);
  const double edge = std::abs(test.edges.values[i] - reference.edges.values[i]);
  const double point = std::abs(test.points.values[i] - reference.points.values[i]);
  const double feature = std::pow(std::max(edge, point) / std::numbers::sqrt2, kFeatureExponent);
  return std::pow(colour, 1 - feature);
}

}  // namespace

FlipResult computeFlip(const Image& test, const Image& reference, double pixelsPerDegree) {
  if (test.width != reference.width || test.height != reference.height) {
    throw UsageError(fmt::format("images of different sizes cannot be compared: {} x {} and {} x {} pixels", test.width,
                                 test.height, reference.width, reference.height));
  }
  if (!(pixelsPerDegree >= 1 && pixelsPerDegree <= 1000)) {
    throw UsageError(fmt::format("{:g} pixels per degree: must be between 1 and 1000", pixelsPerDegree));
  }
  const Appearance testAppearance = appearanceOf(test, pixelsPerDegree);
  const Appearance referenceAppearance = appearanceOf(reference, pixelsPerDegree);
  FlipResult result{test.width, test.height, {}, 0, 0};
  double total = 0;
  for (std::size_t i = 0; i < test.rgb.size(); ++i) {
    const double error = errorAt(testAppearance, referenceAppearance, i);
    total += error;
    result.maximum = std::max(result.maximum, error);
    result.error.push_back(static_cast<float>(error));
  }
  if (!result.error.empty()) result.mean = total / static_cast<double>(result.error.size());
  return result;
}

Image displayed(const Image& image, const DisplayTransform& transform) { return toImage(toPixels8(image, transform)); }

Image errorPicture(const FlipResult& result) {
  Pixels8 pixels{result.width, result.height, {}};
  for (const float error : result.error) {
    const dvec3 signal = magma(double{error});
    for (int c = 0; c < 3; ++c) pixels.rgb.push_back(static_cast<std::uint8_t>(std::lround(255 * signal[c])));
  }
  return toImage(pixels);
}

}  // namespace candela::image

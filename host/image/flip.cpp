// LDR-FLIP: combines the differences of colours, edges and points into one error.
#include "host/image/flip.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/base/errors.h"
#include "host/image/colour_map.h"
#include "host/image/flip_appearance.h"
#include "host/image/flip_colour.h"

namespace candela::image {
namespace {

using glm::dvec3;

constexpr double kFeatureExponent = 0.5;

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

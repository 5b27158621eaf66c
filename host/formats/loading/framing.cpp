// Frames a model in a picture, and estimates how much of the picture it covers.
#include "host/formats/loading/framing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candela::scene {
namespace {

constexpr double kFramingAngle = 30;      // degrees
constexpr double kFramingElevation = 15;  // degrees
constexpr double kFramingMargin = 1.05;

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

}  // namespace

glm::dvec3 centreOf(const Bounds& bounds) { return (glm::dvec3(bounds.min) + glm::dvec3(bounds.max)) / 2.0; }

double radiusOf(const Bounds& bounds) { return glm::length(glm::dvec3(bounds.max) - glm::dvec3(bounds.min)) / 2; }

bool hasExtent(const Bounds& bounds) { return bounds.min != bounds.max; }

ViewAxes axesOf(const Camera& camera) {
  const glm::dvec3 forward = glm::normalize(glm::dvec3(camera.at) - glm::dvec3(camera.from));
  const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(camera.up)));
  return {right, glm::cross(right, forward), forward};
}

double coverageOf(const Camera& camera, const Bounds& bounds) {
  const auto& [right, up, forward] = axesOf(camera);
  const glm::dvec3 centre = centreOf(bounds) - glm::dvec3(camera.from);
  const double radius = radiusOf(bounds);
  if (glm::length(centre) <= radius) return 1;
  const double depth = glm::dot(centre, forward);
  if (depth <= 0) return depth > -radius ? 1 : 0;
  const double halfHeight = camera.orthographicHeight ? double{*camera.orthographicHeight} / 2
                                                      : depth * std::tan(radians(camera.angle) / 2);
  const double halfWidth = halfHeight * camera.width / camera.height;
  const bool isOutside = std::abs(glm::dot(centre, right)) - radius > halfWidth ||
                         std::abs(glm::dot(centre, up)) - radius > halfHeight;
  return isOutside ? 0 : std::min(1.0, std::numbers::pi * radius * radius / (4 * halfWidth * halfHeight));
}

Camera framingCamera(const std::optional<Bounds>& bounds) {
  const glm::dvec3 centre = bounds ? centreOf(*bounds) : glm::dvec3(0);
  const double radius = bounds ? radiusOf(*bounds) : 0;
  const double distance = kFramingMargin * (radius > 0 ? radius : 1) / std::sin(radians(kFramingAngle / 2));
  const double elevation = radians(kFramingElevation);
  Camera view;
  view.at = glm::vec3(centre);
  view.from = glm::vec3(centre + distance * glm::dvec3(0, std::sin(elevation), std::cos(elevation)));
  view.angle = kFramingAngle;
  return view;
}

}  // namespace candela::scene

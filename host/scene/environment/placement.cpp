// Computes directions and axes.
#include "host/scene/environment/placement.h"

#include <cmath>
#include <numbers>

namespace candela::environment {

glm::dvec3 directionOf(double x, double y, std::uint32_t width, std::uint32_t height) {
  const double azimuth = std::numbers::pi * (2 * x / width - 1);
  const double elevation = std::numbers::pi * (0.5 - y / height);
  return {std::cos(elevation) * std::cos(azimuth), std::sin(elevation), std::cos(elevation) * std::sin(azimuth)};
}

void place(scene::Environment& environment, const glm::vec3& up, double degrees) {
  const glm::dvec3 y(up);
  const glm::dvec3 x = up.x != 0 ? glm::dvec3(0, -up.x, 0) : glm::dvec3(1, 0, 0);
  const glm::dvec3 z = glm::cross(x, y);
  const double radians = degrees * std::numbers::pi / 180;
  environment.axes[0] = glm::vec3(std::cos(radians) * x - std::sin(radians) * z);
  environment.axes[1] = up;
  environment.axes[2] = glm::vec3(std::sin(radians) * x + std::cos(radians) * z);
}

}  // namespace candela::environment

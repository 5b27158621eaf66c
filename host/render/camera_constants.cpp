#include "host/render/camera_constants.h"

#include <cmath>
#include <numbers>

namespace candela {

void setCamera(gpu::RenderConstants& constants, const Camera& camera, const Extent& size) {
  const glm::dvec3 from(camera.from);
  const glm::dvec3 backward = from - glm::dvec3(camera.at);
  const double distance = glm::length(backward);
  const glm::dvec3 n = backward / distance;
  const glm::dvec3 u = glm::normalize(glm::cross(glm::dvec3(camera.up), n));
  const glm::dvec3 v = glm::cross(n, u);
  const double height = 2 * distance * std::tan(camera.angle * std::numbers::pi / 360);
  const double width = height * size.width / size.height;
  const double lensRadius = camera.aperture * height / camera.height;
  constants.cameraOrigin = gpu::vec4(glm::vec3(from), 0);
  constants.cameraForward = gpu::vec4(glm::vec3(-backward), 0);
  constants.cameraRight = gpu::vec4(glm::vec3(width * u), 1.0f / static_cast<float>(size.width));
  constants.cameraUp = gpu::vec4(glm::vec3(height * v), 1.0f / static_cast<float>(size.height));
  constants.lensRight = gpu::vec4(glm::vec3(lensRadius * u), static_cast<float>(1.0 / camera.focal));
  constants.lensUp = gpu::vec4(glm::vec3(lensRadius * v), 0);
}

}  // namespace candela

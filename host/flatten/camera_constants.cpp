// Computes the constants of the camera for a device.
#include "host/flatten/camera_constants.h"

#include <cmath>
#include <numbers>

namespace candela::flatten {
namespace {

// One direction of the image: pixels that fill the view, and where in them rays go that are not jittered.
struct Axis {
  std::uint32_t pixels;
  float origin;
};

Axis axisOf(std::uint32_t extent, render::PixelOrigin origin) {
  if (origin == render::PixelOrigin::corner && extent > 1) return {extent - 1, 0};
  return {extent, 0.5f};
}

}  // namespace

void setCamera(gpu::RenderConstants& constants, const scene::Camera& camera, const render::RenderSettings& settings) {
  const Axis across = axisOf(settings.size.width, settings.pixelOrigin);
  const Axis down = axisOf(settings.size.height, settings.pixelOrigin);
  const glm::dvec3 from(camera.from);
  const glm::dvec3 backward = from - glm::dvec3(camera.at);
  const double distance = glm::length(backward);
  const glm::dvec3 n = backward / distance;
  const glm::dvec3 u = glm::normalize(glm::cross(glm::dvec3(camera.up), n));
  const glm::dvec3 v = glm::cross(n, u);
  const double height = 2 * distance * std::tan(camera.angle * std::numbers::pi / 360);
  const double width = height * across.pixels / down.pixels;
  const double lensRadius = camera.aperture * height / camera.height;
  constants.cameraOrigin = gpu::vec4(glm::vec3(from), across.origin);
  constants.cameraForward = gpu::vec4(glm::vec3(-backward), down.origin);
  constants.cameraRight = gpu::vec4(glm::vec3(width * u), 1.0f / static_cast<float>(across.pixels));
  constants.cameraUp = gpu::vec4(glm::vec3(height * v), 1.0f / static_cast<float>(down.pixels));
  constants.lensRight = gpu::vec4(glm::vec3(lensRadius * u), static_cast<float>(1.0 / camera.focal));
  constants.lensUp = gpu::vec4(glm::vec3(lensRadius * v), 0);
}

}  // namespace candela::flatten

// Computes the constants of the camera and of the random numbers for a device.
#include "host/trace/flatten/camera_constants.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candela::flatten {
namespace {

// One direction of the image: the number of pixels that fill the view, and the position within them of rays without
// jitter.
struct Axis {
  std::uint32_t pixels;
  float origin;
};

Axis axisOf(std::uint32_t extent, render::PixelOrigin origin) {
  if (origin == render::PixelOrigin::corner && extent > 1) return {extent - 1, 0};
  return {extent, 0.5f};
}

// Height of the view plane.
double viewHeight(const scene::Camera& camera, double distance) {
  if (camera.orthographicHeight) return *camera.orthographicHeight;
  return 2 * distance * std::tan(camera.angle * std::numbers::pi / 360);
}

// Maximum length of `ao` rays.
float aoDistance(const scene::Camera& camera, const render::ImageSettings& image) {
  if (image.aoDistance) return *image.aoDistance;
  return static_cast<float>(0.25 * glm::distance(glm::dvec3(camera.from), glm::dvec3(camera.at)));
}

// Returns n of the n x n strata; 0 if there are none.
std::uint32_t strataPerSide(const render::ImageSettings& image) {
  if (image.sampler != render::SamplerKind::stratified) return 0;
  return std::min(static_cast<std::uint32_t>(std::sqrt(static_cast<double>(image.sampleCount))), 256u);
}

}  // namespace

void setSampling(gpu::RenderConstants& constants, const render::ImageSettings& image) {
  constants.seed = image.seed;
  constants.strataPerSide = strataPerSide(image);
}

void setCamera(gpu::RenderConstants& constants, const scene::Camera& camera, const render::ImageSettings& image) {
  const Axis across = axisOf(image.size.width, image.pixelOrigin);
  const Axis down = axisOf(image.size.height, image.pixelOrigin);
  const glm::dvec3 from(camera.from);
  const glm::dvec3 backward = from - glm::dvec3(camera.at);
  const double distance = glm::length(backward);
  const glm::dvec3 n = backward / distance;
  const glm::dvec3 u = glm::normalize(glm::cross(glm::dvec3(camera.up), n));
  const glm::dvec3 v = glm::cross(n, u);
  const glm::dvec3 right = camera.isMirrored ? -u : u;
  const double height = viewHeight(camera, distance);
  const double width = height * across.pixels / down.pixels;
  const double lensRadius = camera.aperture * height / camera.height;
  glm::dvec3 origin = from, forward = -backward;
  if (camera.shift != glm::vec2(0)) {
    (camera.orthographicHeight ? origin : forward) += double{camera.shift.x} * width * right -
                                                      double{camera.shift.y} * height * v;
  }
  constants.cameraOrigin = glm::vec3(origin);
  constants.pixelOriginX = across.origin;
  constants.cameraForward = glm::vec3(forward);
  constants.pixelOriginY = down.origin;
  constants.cameraRight = glm::vec3(width * right);
  constants.inversePixelsAcross = 1.0f / static_cast<float>(across.pixels);
  constants.cameraUp = glm::vec3(height * v);
  constants.inversePixelsDown = 1.0f / static_cast<float>(down.pixels);
  constants.lensRight = glm::vec3(lensRadius * right);
  constants.inverseFocal = static_cast<float>(1.0 / camera.focal);
  constants.lensUp = glm::vec3(lensRadius * v);
  constants.aoDistance = aoDistance(camera, image);
}

void noteCamera(const scene::Camera& camera, const gpu::RenderConstants& constants, SceneShape& shape) {
  shape.features.orthographic = camera.orthographicHeight.has_value();
  shape.hasLens = constants.lensUp != glm::vec3(0);
}

}  // namespace candela::flatten

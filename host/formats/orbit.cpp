// Rotates the vectors of a camera.
#include "host/formats/orbit.h"

#include <cmath>
#include <numbers>

#include "host/scene/bounds.h"

namespace candela::formats {
namespace {

/// A rotation about a unit axis (Rodrigues' formula).
class Rotation {
 public:
  Rotation(const glm::dvec3& axis, double degrees)
      : axis_(axis),
        cosine_(std::cos(degrees * std::numbers::pi / 180)),
        sine_(std::sin(degrees * std::numbers::pi / 180)) {}

  glm::dvec3 operator()(const glm::dvec3& vector) const {
    return cosine_ * vector + sine_ * glm::cross(axis_, vector) + (1 - cosine_) * glm::dot(axis_, vector) * axis_;
  }

 private:
  glm::dvec3 axis_;
  double cosine_, sine_;
};

glm::dvec3 centreOf(const scene::Scene& scene) {
  const std::optional<scene::Bounds> bounds = scene::boundsOf(scene);
  return bounds ? (glm::dvec3(bounds->min) + glm::dvec3(bounds->max)) / 2.0 : glm::dvec3(scene.camera->at);
}

}  // namespace

scene::Camera orbitedCamera(const scene::Scene& scene, double degrees) {
  const Rotation rotation(glm::dvec3(scene.up), degrees);
  const glm::dvec3 centre = centreOf(scene);
  const auto turned = [&](const glm::vec3& point) { return glm::vec3(centre + rotation(glm::dvec3(point) - centre)); };
  scene::Camera camera = *scene.camera;
  camera.from = turned(camera.from);
  camera.at = turned(camera.at);
  camera.up = glm::vec3(rotation(glm::dvec3(camera.up)));
  return camera;
}

}  // namespace candela::formats

// Rotates the vectors of a camera.
#include "host/formats/orbit.h"

#include <cmath>
#include <numbers>

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

}  // namespace

scene::Camera orbitedCamera(const scene::Scene& scene, double degrees) {
  const Rotation rotation(glm::dvec3(scene.up), degrees);
  scene::Camera camera = *scene.camera;
  const glm::dvec3 target(camera.at);
  camera.from = glm::vec3(target + rotation(glm::dvec3(camera.from) - target));
  camera.up = glm::vec3(rotation(glm::dvec3(camera.up)));
  return camera;
}

}  // namespace candela::formats

// Rays that structures find easy and hard.
#pragma once
#include <cstdint>
#include <vector>

#include "host/trace/accel/grid.h"
#include "tests/trace/accel/inputs.h"
#include "tests/trace/accel/ray_tests.h"

namespace candela::test {

using namespace accel;

/// Rays at and around a box: from within, from far away, from given points, along axes, and along the faces between the
/// cells of a grid.
class RayMaker {
 public:
  RayMaker(const GridShape& shape, std::uint64_t seed) : shape_(shape), random_(seed) {
    if (shape.sides.x == 0) return;  // nothing there: around the origin, any ray will do
    centre_ = (glm::dvec3(shape.bounds.min) + glm::dvec3(shape.bounds.max)) / 2.0;
    halfExtent_ = shape.bounds.extent() / 2.0;
  }

  /// `surfacePoint` is a suitable origin of rays.
  Ray<float> next(const glm::vec3& surfacePoint) {
    const double choice = random_.real();
    if (choice < 0.3) return {inBox(1.2), anyDirection()};
    if (choice < 0.5) return {surfacePoint, anyDirection()};
    if (choice < 0.7) return fromAfar();
    if (choice < 0.85) return {inBox(1.5), axisDirection()};
    return alongFaces();
  }

 private:
  glm::vec3 inBox(double share) { return glm::vec3(centre_ + share * halfExtent_ * random_.inCube(-1, 1)); }

  // A tenth of them with one component that is 0, or next to it.
  glm::vec3 anyDirection() {
    glm::vec3 direction(random_.direction());
    if (random_.real() < 0.1) {
      const double choice = random_.real();
      direction[axis()] = choice < 0.5 ? 0.0f : choice < 0.75 ? -0.0f : 1e-30f;
    }
    return glm::normalize(direction);
  }

  glm::vec3 axisDirection() {
    glm::vec3 direction(0);
    direction[axis()] = random_.real() < 0.5 ? -1.0f : 1.0f;
    return direction;
  }

  Ray<float> fromAfar() {
    const double size = glm::length(halfExtent_) + 1e-3;
    const glm::vec3 origin(centre_ + size * std::exp2(random_.real(0.5, 14)) * random_.direction());
    const glm::dvec3 path = glm::dvec3(inBox(1.0)) - glm::dvec3(origin);
    return {origin, glm::vec3(glm::normalize(path))};
  }

  // In one or two planes between cells, or within a rounding of them.
  Ray<float> alongFaces() {
    Ray<float> ray{inBox(1.1), anyDirection()};
    const int kept = axis();
    for (int i = 0; i < 3; ++i) {
      if (i == kept || (i == (kept + 1) % 3 && random_.real() < 0.5)) continue;
      ray.origin[i] = face(i);
      ray.direction[i] = 0;
    }
    const float length = glm::length(ray.direction);
    ray.direction = length > 0 ? ray.direction / length : axisDirection();
    return ray;
  }

  float face(int i) {
    const double cells = std::max(1u, shape_.sides[i]);
    const double number = std::floor(random_.real(0, cells + 1));
    const auto plane = static_cast<float>(centre_[i] - halfExtent_[i] + 2 * halfExtent_[i] * number / cells);
    const double choice = random_.real();
    const float rounding = std::max(std::abs(plane) * 0x1p-23f, 1e-30f);  // no denormals: devices may flush them
    return choice < 0.5 ? plane : choice < 0.75 ? plane - rounding : plane + rounding;
  }

  int axis() { return static_cast<int>(random_.real(0, 3)); }

  const GridShape& shape_;
  Random random_;
  glm::dvec3 centre_{0};
  glm::dvec3 halfExtent_{1};
};

}  // namespace candela::test

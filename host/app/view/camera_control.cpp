// Computes orbits, pans and flights in double precision.
#include "host/app/view/camera_control.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candela::view {
namespace {

// Rotates `v` by `angle` about the unit vector `axis` (Rodrigues).
glm::dvec3 rotated(const glm::dvec3& v, const glm::dvec3& axis, double angle) {
  return v * std::cos(angle) + glm::cross(axis, v) * std::sin(angle) +
         axis * (glm::dot(axis, v) * (1 - std::cos(angle)));
}

}  // namespace

CameraControl::Axes CameraControl::axes() const {
  const glm::dvec3 towards = glm::dvec3(camera_.at) - glm::dvec3(camera_.from);
  const double distance = glm::length(towards);
  const glm::dvec3 forward = towards / distance;
  const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(camera_.up)));
  return {right, glm::cross(right, forward), forward, distance};
}

double CameraControl::viewHeight() const {
  if (camera_.orthographicHeight) return *camera_.orthographicHeight;
  return 2 * axes().distance * std::tan(camera_.angle * std::numbers::pi / 360);
}

// Turns a direction to the left about the axis that points up, and then upward, but never as far as to that axis.
glm::dvec3 CameraControl::turned(const glm::dvec3& direction, const glm::dvec2& turn) const {
  const glm::dvec3 up = glm::normalize(glm::dvec3(camera_.up));
  const glm::dvec3 unit = glm::normalize(direction);
  const double polar = std::acos(std::clamp(glm::dot(unit, up), -1.0, 1.0));
  const double wanted = std::clamp(polar - turn.y, kMinPolarAngle, std::numbers::pi - kMinPolarAngle);
  const glm::dvec3 axis = glm::normalize(glm::cross(unit, up));
  const glm::dvec3 raised = rotated(unit, axis, polar - wanted);
  return rotated(raised, up, turn.x) * glm::length(direction);
}

void CameraControl::orbit(const glm::dvec2& turn) {
  const glm::dvec3 at(camera_.at);
  camera_.from = glm::vec3(at + turned(glm::dvec3(camera_.from) - at, {-turn.x, turn.y}));
}

void CameraControl::look(const glm::dvec2& turn) {
  const glm::dvec3 from(camera_.from);
  camera_.at = glm::vec3(from + turned(glm::dvec3(camera_.at) - from, {-turn.x, turn.y}));
}

void CameraControl::translate(const glm::dvec3& offset) {
  camera_.from = glm::vec3(glm::dvec3(camera_.from) + offset);
  camera_.at = glm::vec3(glm::dvec3(camera_.at) + offset);
}

void CameraControl::pan(const glm::dvec2& heights) {
  const Axes now = axes();
  translate((heights.x * now.right + heights.y * now.up) * viewHeight());
}

void CameraControl::fly(const glm::dvec3& distances) {
  const Axes now = axes();
  translate((distances.x * now.right + distances.y * now.up + distances.z * now.forward) * now.distance);
}

void CameraControl::dolly(double factor) {
  if (camera_.orthographicHeight) {
    camera_.orthographicHeight = static_cast<float>(*camera_.orthographicHeight * factor);
    return;
  }
  const glm::dvec3 at(camera_.at);
  camera_.from = glm::vec3(at + (glm::dvec3(camera_.from) - at) * factor);
}

}  // namespace candela::view

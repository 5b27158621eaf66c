// A camera that input moves: about its target, along the picture, or through the scene.
#pragma once
#include <glm/glm.hpp>

#include "host/scene/scene.h"

namespace candela::view {

/// Moves copies of a camera. Its `up` stays the axis that points up, so that the horizon stays level, and the angle
/// between it and the view is at least kMinPolarAngle. `at` is the point that orbits keep.
class CameraControl {
 public:
  static constexpr double kMinPolarAngle = 0.01;  ///< radians

  explicit CameraControl(const scene::Camera& camera) : camera_(camera), start_(camera) {}

  const scene::Camera& camera() const { return camera_; }
  /// Replaces the camera, also as that of reset().
  void restart(const scene::Camera& camera) { camera_ = start_ = camera; }
  void reset() { camera_ = start_; }

  /// Turns the camera about its target, in radians: `turn.x` > 0 moves it to the left, `turn.y` > 0 upward.
  void orbit(const glm::dvec2& turn);
  /// Turns the view about the camera, in radians: `turn.x` > 0 to the right, `turn.y` > 0 upward.
  void look(const glm::dvec2& turn);
  /// Moves camera and target to the right and upward; the unit is the height of the view plane through the target.
  void pan(const glm::dvec2& heights);
  /// Moves camera and target to the right, upward and forward; the unit is the distance between the two.
  void fly(const glm::dvec3& distances);
  /// Multiplies the distance from the target, or the height of an orthographic view, by `factor` > 0.
  void dolly(double factor);

 private:
  struct Axes {
    glm::dvec3 right, up, forward;  ///< unit
    double distance;
  };
  Axes axes() const;
  double viewHeight() const;
  void translate(const glm::dvec3& offset);
  glm::dvec3 turned(const glm::dvec3& direction, const glm::dvec2& turn) const;

  scene::Camera camera_;
  scene::Camera start_;
};

}  // namespace candela::view

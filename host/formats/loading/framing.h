// Views of bounding boxes.
#pragma once
#include <glm/glm.hpp>
#include <optional>

#include "host/scene/bounds.h"
#include "host/scene/scene.h"

namespace candela::scene {

/// Returns the centre of the box, and half its diagonal.
glm::dvec3 centreOf(const Bounds& bounds);
double radiusOf(const Bounds& bounds);
/// Returns whether the box is more than a point.
bool hasExtent(const Bounds& bounds);

/// Unit vectors of the picture in the scene, at right angles to each other.
struct ViewAxes {
  glm::dvec3 right;
  glm::dvec3 up;
  glm::dvec3 forward;
};
ViewAxes axesOf(const Camera& camera);

/// Returns the maximum fraction of the picture that the sphere around `bounds` covers: 1 if the camera is in it, 0 if
/// it is outside the view. Its size is taken at its centre.
double coverageOf(const Camera& camera, const Bounds& bounds);

/// A view from the front (+Z), raised by 15 degrees, of the sphere around the box, with a margin of 5 %.
Camera framingCamera(const std::optional<Bounds>& bounds);

}  // namespace candela::scene

// Views of bounding boxes.
#pragma once
#include <glm/glm.hpp>
#include <optional>

#include "host/scene/scene.h"

namespace candela::gltf {

struct Box {
  glm::dvec3 min;
  glm::dvec3 max;
};

/// Unit vectors of the picture in the scene, at right angles to each other.
struct ViewAxes {
  glm::dvec3 right;
  glm::dvec3 up;
  glm::dvec3 forward;
};
ViewAxes axesOf(const scene::Camera& camera);

/// Returns the maximum fraction of the picture that the sphere around `bounds` covers: 1 if the camera is in it, 0 if
/// it is outside the view. Its size is taken at its centre.
double coverageOf(const scene::Camera& camera, const Box& bounds);

/// A view from the front (+Z), raised by 15 degrees, of the sphere around the box, with a margin of 5 %.
scene::Camera framingCamera(const std::optional<Box>& bounds);

}  // namespace candela::gltf

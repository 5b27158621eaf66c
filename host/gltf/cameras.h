// The view of a glTF file: one of its cameras, or a view that frames everything.
#pragma once
#include <optional>
#include <string>

#include "host/gltf/nodes.h"
#include "host/scene/scene.h"

namespace candela::gltf {

struct Box {
  glm::dvec3 min;
  glm::dvec3 max;
};

struct View {
  scene::Camera camera;
  std::string description;  ///< for reports
};

/// Returns the camera that `wish` names (LoadOptions::camera); without a wish, the first camera of a visible node. A
/// view that frames `bounds` if there is none, or if the wish is "none". The target is as far away as the centre of
/// `bounds`. Throws JsonError for a wrong camera, and FileError, which lists the cameras, for a wish that fits none.
View chooseView(const Value& root, const NodeTree& nodes, const std::optional<std::string>& wish,
                const std::optional<Box>& bounds);

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

/// The view of a perspective or an orthographic camera at a node, without the node's scale.
scene::Camera cameraAt(const Value& camera, const glm::dmat4& world, const std::optional<Box>& bounds);

/// A view from the front (+Z), raised by 15 degrees, of the sphere around the box, with a margin of 5 %.
scene::Camera framingCamera(const std::optional<Box>& bounds);

}  // namespace candela::gltf

// The view of a glTF file: one of its cameras, or a view that frames everything.
#pragma once
#include <functional>
#include <optional>
#include <string>

#include "host/formats/gltf/nodes.h"
#include "host/formats/loading/framing.h"
#include "host/scene/scene.h"

namespace candela::gltf {

struct View {
  scene::Camera camera;
  std::string description;  ///< for reports
};

/// Returns the camera that `wish` names (LoadOptions::camera); without a wish, the first camera of a visible node. Its
/// target is as far away as the centre of `bounds`. If there is none, or if the wish is "none", a view that frames what
/// `framed` returns. Throws JsonError for a wrong camera, and FileError, which lists the cameras, for a wish that fits
/// none.
View chooseView(const Value& root, const NodeTree& nodes, const std::optional<std::string>& wish,
                const std::optional<scene::Bounds>& bounds,
                const std::function<std::optional<scene::Bounds>()>& framed);

/// The view of a perspective or an orthographic camera at a node, without the node's scale.
scene::Camera cameraAt(const Value& camera, const glm::dmat4& world, const std::optional<scene::Bounds>& bounds);

}  // namespace candela::gltf

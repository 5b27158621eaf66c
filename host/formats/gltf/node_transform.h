// The transforms of nodes.
#pragma once
#include <glm/glm.hpp>

#include "host/formats/gltf/animation.h"

namespace candela::gltf {

/// The transform of a node relative to its parent: its matrix, or T R S with quaternions of any length. Throws
/// JsonError.
glm::dmat4 localTransform(const Value& node, const NodePose& pose);

/// Returns T R S for a quaternion of any length; length 0 means no rotation.
glm::dmat4 compose(const glm::dvec3& translation, const glm::dquat& rotation, const glm::dvec3& scale);

}  // namespace candela::gltf

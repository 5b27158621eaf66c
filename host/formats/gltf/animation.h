// An animation at a point in time.
#pragma once
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/formats/gltf/accessor.h"

namespace candela::gltf {

/// The properties of a node that an animation sets. The node keeps its own value of each empty member.
struct NodePose {
  std::optional<glm::dvec3> translation;
  std::optional<glm::dquat> rotation;
  std::optional<glm::dvec3> scale;
  std::vector<double> weights;  ///< of morph targets; empty: not set
};

/// By node index.
using Pose = std::map<std::size_t, NodePose>;

/// Evaluates every channel of an animation at `seconds`; before the first and after the last key frame, the values
/// of that frame apply. `wish` is the name or the index of the animation, and the first one if it is empty. The pose is
/// empty if there is no animation. Properties that KHR_animation_pointer animates are set in `document`, which is the
/// content of `root`. Throws JsonError, and FileError with the names of all animations if none is the wish.
Pose poseAt(const Value& root, const std::optional<std::string>& wish, double seconds, Accessors& accessors,
            nlohmann::json& document);

/// Returns whether an animation of the file animates properties by KHR_animation_pointer. Throws JsonError.
bool hasPointers(const Value& root);

/// Returns the time of the last key frame of an animation, chosen as by poseAt(), in seconds; nothing if the file has
/// no animation. Throws as poseAt() does.
std::optional<double> animationEnd(const Value& root, const std::optional<std::string>& wish, Accessors& accessors);

}  // namespace candela::gltf

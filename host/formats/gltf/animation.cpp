// Chooses an animation, and evaluates its channels.
#include "host/formats/gltf/animation.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/base/quote.h"
#include "host/formats/gltf/animation_pointer.h"

namespace candela::gltf {
namespace {

constexpr const char* kPointerPath = "pointer";

void setPath(const Value& path, const Value& sampler, double seconds, Accessors& accessors, NodePose& pose) {
  const std::string& name = path.text();
  const bool isRotation = name == "rotation";
  const bool isVector = name == "translation" || name == "scale";
  if (!isRotation && !isVector && name != "weights")
    path.fail(scene::quote(name) + " is not a path of an animated node");
  const std::size_t components = isRotation ? 4 : isVector ? 3 : 1;
  const std::vector<double> value = evaluate(readSampler(sampler, components, accessors), seconds, isRotation);
  if (isRotation) {
    pose.rotation = asQuaternion(value);
  } else if (name == "translation") {
    pose.translation = glm::dvec3(value[0], value[1], value[2]);
  } else if (name == "scale") {
    pose.scale = glm::dvec3(value[0], value[1], value[2]);
  } else {
    pose.weights = value;
  }
}

[[noreturn]] void refuseWish(const Value& animations, const std::string& wish) {
  std::string names;
  for (std::size_t i = 0; i < animations.size(); ++i) {
    const std::string name = animations[i].textOr("name", "");
    names += fmt::format("{} {}{}", i == 0 ? "" : ",", i, name.empty() ? "" : " " + scene::quote(name));
  }
  throw FileError(fmt::format("no animation {}; the file has the animations{}", scene::quote(wish), names));
}

// Names come before indices, since an animation may be called "1".
Value chosenAnimation(const Value& animations, const std::optional<std::string>& wish) {
  if (!wish) return animations[0];
  for (std::size_t i = 0; i < animations.size(); ++i) {
    if (animations[i].textOr("name", "") == *wish) return animations[i];
  }
  for (std::size_t i = 0; i < animations.size(); ++i) {
    if (fmt::to_string(i) == *wish) return animations[i];
  }
  refuseWish(animations, *wish);
}

}  // namespace

Pose poseAt(const Value& root, const std::optional<std::string>& wish, double seconds, Accessors& accessors,
            nlohmann::json& document) {
  Pose pose;
  if (root.sizeOf("animations") == 0) return pose;
  const Value animation = chosenAnimation(root.require("animations"), wish);
  const Value channels = animation.require("channels");
  const Value samplers = animation.require("samplers");
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const Value target = channels[i].require("target");
    const std::size_t sampler = channels[i].require("sampler").indexInto("samplers", samplers.size());
    if (target.require("path").text() == kPointerPath) {
      setPointedProperty(target, samplers[sampler], seconds, accessors, document);
      continue;
    }
    const std::optional<Value> node = target.find("node");
    if (!node) continue;  // the target of another extension
    const std::size_t index = node->indexInto("nodes", root.sizeOf("nodes"));
    setPath(target.require("path"), samplers[sampler], seconds, accessors, pose[index]);
  }
  return pose;
}

bool hasPointers(const Value& root) {
  const std::optional<Value> animations = root.find("animations");
  if (!animations) return false;
  for (const Value& animation : animations->items()) {
    for (const Value& channel : animation.require("channels").items()) {
      if (channel.require("target").textOr("path", "") == kPointerPath) return true;
    }
  }
  return false;
}

std::optional<double> animationEnd(const Value& root, const std::optional<std::string>& wish, Accessors& accessors) {
  if (root.sizeOf("animations") == 0) return std::nullopt;
  const Value animation = chosenAnimation(root.require("animations"), wish);
  const Value samplers = animation.require("samplers");
  double end = 0;
  for (std::size_t i = 0; i < samplers.size(); ++i) {
    const std::vector<float> times = accessors.read<float>(samplers[i].require("input"));
    if (!times.empty()) end = std::max(end, static_cast<double>(times.back()));
  }
  return end;
}

}  // namespace candela::gltf

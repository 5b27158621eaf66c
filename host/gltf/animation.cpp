// Evaluates the channels of an animation (glTF 2.0 specification, section 3.11 and appendix C).
#include "host/gltf/animation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/scene/quote.h"

namespace candela::gltf {
namespace {

enum class Interpolation : std::uint8_t { step, linear, cubic };

/// Values at key frames, `width` numbers each; of CUBICSPLINE, three times as many: in-tangent, value, out-tangent.
struct Sampler {
  std::vector<float> times;
  std::vector<float> values;
  Interpolation interpolation;
  std::size_t width;

  const float* frame(std::size_t i) const {
    return values.data() + i * width * (interpolation == Interpolation::cubic ? 3 : 1);
  }
  const float* value(std::size_t i) const { return frame(i) + (interpolation == Interpolation::cubic ? width : 0); }
};

Interpolation interpolationOf(const Value& sampler) {
  const std::string name = sampler.textOr("interpolation", "LINEAR");
  if (name == "LINEAR") return Interpolation::linear;
  if (name == "STEP") return Interpolation::step;
  if (name != "CUBICSPLINE")
    sampler.require("interpolation").fail(scene::quote(name) + " is not an interpolation mode");
  return Interpolation::cubic;
}

template <class Vector>
std::vector<float> flatten(const std::vector<Vector>& vectors) {
  std::vector<float> flat;
  for (const Vector& vector : vectors) {
    for (glm::length_t c = 0; c < Vector::length(); ++c) flat.push_back(vector[c]);
  }
  return flat;
}

std::vector<float> readValues(const Value& reference, std::size_t components, Accessors& accessors) {
  if (components == 3) return flatten(accessors.read<glm::vec3>(reference));
  if (components == 4) return flatten(accessors.read<glm::vec4>(reference));
  return accessors.read<float>(reference);
}

/// `components`: 3 or 4 numbers for each frame, or 1 of which each frame has any number.
Sampler readSampler(const Value& sampler, std::size_t components, Accessors& accessors) {
  Sampler result{accessors.read<float>(sampler.require("input")),
                 readValues(sampler.require("output"), components, accessors), interpolationOf(sampler), components};
  const std::size_t parts = result.times.size() * (result.interpolation == Interpolation::cubic ? 3 : 1);
  const std::size_t perFrame = result.values.size() / parts;
  if (perFrame == 0 || perFrame * parts != result.values.size() || (components > 1 && perFrame != components)) {
    sampler.require("output").fail(
        fmt::format("{} numbers for {} key frames", result.values.size(), result.times.size()));
  }
  if (!std::ranges::is_sorted(result.times)) sampler.require("input").fail("the times do not increase");
  result.width = perFrame;
  return result;
}

double cubic(const Sampler& sampler, std::size_t i, std::size_t c, double t, double duration) {
  const double v0 = sampler.value(i)[c];
  const double v1 = sampler.value(i + 1)[c];
  const double out0 = duration * double{sampler.frame(i)[2 * sampler.width + c]};
  const double in1 = duration * double{sampler.frame(i + 1)[c]};
  const double t2 = t * t;
  const double t3 = t2 * t;
  return (2 * t3 - 3 * t2 + 1) * v0 + (t3 - 2 * t2 + t) * out0 + (3 * t2 - 2 * t3) * v1 + (t3 - t2) * in1;
}

std::vector<double> valueOf(const Sampler& sampler, std::size_t i) {
  return {sampler.value(i), sampler.value(i) + sampler.width};
}

glm::dquat asQuaternion(const std::vector<double>& xyzw) { return {xyzw[3], xyzw[0], xyzw[1], xyzw[2]}; }

/// Between frame i and the next one, at t in [0, 1]. Rotations are interpolated on the sphere.
std::vector<double> between(const Sampler& sampler, std::size_t i, double t, double duration, bool isRotation) {
  std::vector<double> result = valueOf(sampler, i);
  if (sampler.interpolation == Interpolation::step) return t < 1 ? result : valueOf(sampler, i + 1);
  const std::vector<double> next = valueOf(sampler, i + 1);
  if (sampler.interpolation == Interpolation::linear && isRotation) {
    const glm::dquat q = glm::slerp(asQuaternion(result), asQuaternion(next), t);
    return {q.x, q.y, q.z, q.w};
  }
  for (std::size_t c = 0; c < sampler.width; ++c) {
    const bool isCubic = sampler.interpolation == Interpolation::cubic;
    result[c] = isCubic ? cubic(sampler, i, c, t, duration) : result[c] + t * (next[c] - result[c]);
  }
  return result;
}

std::vector<double> evaluate(const Sampler& sampler, double seconds, bool isRotation) {
  const std::vector<float>& times = sampler.times;
  if (seconds <= double{times.front()}) return valueOf(sampler, 0);
  if (seconds >= double{times.back()}) return valueOf(sampler, times.size() - 1);
  const auto after = std::ranges::upper_bound(times, seconds, {}, [](float time) { return double{time}; });
  const auto i = static_cast<std::size_t>(after - times.begin()) - 1;
  const double duration = double{times[i + 1]} - double{times[i]};
  return between(sampler, i, (seconds - double{times[i]}) / duration, duration, isRotation);
}

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

Pose poseAt(const Value& root, const std::optional<std::string>& wish, double seconds, Accessors& accessors) {
  Pose pose;
  if (root.sizeOf("animations") == 0) return pose;
  const Value animation = chosenAnimation(root.require("animations"), wish);
  const Value channels = animation.require("channels");
  const Value samplers = animation.require("samplers");
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const Value target = channels[i].require("target");
    const std::optional<Value> node = target.find("node");
    if (!node || target.require("path").text() == "pointer") continue;  // the target of an extension
    const std::size_t index = node->indexInto("nodes", root.sizeOf("nodes"));
    const std::size_t sampler = channels[i].require("sampler").indexInto("samplers", samplers.size());
    setPath(target.require("path"), samplers[sampler], seconds, accessors, pose[index]);
  }
  return pose;
}

}  // namespace candela::gltf

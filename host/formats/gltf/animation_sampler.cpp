// Interpolates key frames (glTF 2.0 specification, section 3.11 and appendix C).
#include "host/formats/gltf/animation_sampler.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/base/quote.h"

namespace candela::gltf {
namespace {

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
  if (components == 2) return flatten(accessors.read<glm::vec2>(reference));
  if (components == 3) return flatten(accessors.read<glm::vec3>(reference));
  if (components == 4) return flatten(accessors.read<glm::vec4>(reference));
  return accessors.read<float>(reference);
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

}  // namespace

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

std::vector<double> evaluate(const Sampler& sampler, double seconds, bool isRotation) {
  const std::vector<float>& times = sampler.times;
  if (seconds <= double{times.front()}) return valueOf(sampler, 0);
  if (seconds >= double{times.back()}) return valueOf(sampler, times.size() - 1);
  const auto after = std::ranges::upper_bound(times, seconds, {}, [](float time) { return double{time}; });
  const auto i = static_cast<std::size_t>(after - times.begin()) - 1;
  const double duration = double{times[i + 1]} - double{times[i]};
  return between(sampler, i, (seconds - double{times[i]}) / duration, duration, isRotation);
}

}  // namespace candela::gltf
